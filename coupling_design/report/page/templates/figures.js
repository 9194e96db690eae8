"use strict";
(function () {
  const PRINTED_WIDTH = 660; // pixels that fit between the margins of A4
  const PRINTED_HEIGHT = 0.75; // of that on the screen
  const config = {
    displaylogo: false,
    responsive: true,
    modeBarButtonsToRemove: ["select2d", "lasso2d", "autoScale2d"],
    toImageButtonOptions: { format: "svg" },
  };
  const drawings = [];
  let isPrinting = false;

  function draw(figure) {
    const drawing = figure.querySelector(".drawing");
    const content = JSON.parse(
      figure.querySelector("script[type='application/json']").textContent
    );
    const whole = content.layout.xaxis.range;
    drawing.replaceChildren();
    Plotly.newPlot(drawing, content.data, content.layout, config);
    drawings.push({ drawing: drawing, height: content.layout.height });
    for (const button of figure.querySelectorAll("button[data-view]")) {
      button.addEventListener("click", function () {
        const closer = [Number(button.dataset.from), Number(button.dataset.to)];
        const isAll = button.dataset.view === "all";
        Plotly.relayout(drawing, {
          "xaxis.range": (isAll ? whole : closer).slice(),
        });
      });
    }
  }

  function fitPaper() {
    if (isPrinting) return;
    isPrinting = true;
    for (const { drawing, height } of drawings) {
      resize(drawing, Math.round(PRINTED_HEIGHT * height), PRINTED_WIDTH);
    }
  }

  function fitScreen() {
    isPrinting = false;
    for (const { drawing, height } of drawings) resize(drawing, height, null);
  }

  function resize(drawing, height, width) {
    drawing.style.height = height + "px";
    Plotly.relayout(drawing, { height: height, width: width, autosize: !width });
  }

  document.querySelectorAll("figure").forEach(draw);
  window.addEventListener("beforeprint", fitPaper);
  window.addEventListener("afterprint", fitScreen);
  document.documentElement.dataset.figures = String(drawings.length);
})();
