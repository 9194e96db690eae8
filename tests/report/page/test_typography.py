import pytest

from coupling_design.report.page.typography import typeset


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("peak F_c [kN]", "peak F<sub>c</sub> [kN]"),
        ("T_Kmax2 x S_t", "T<sub>Kmax2</sub> x S<sub>t</sub>"),
        ("F_min less", "F<sub>min</sub> less"),
        ("transmission_force", "transmission_force"),
        ("my_case", "my_case"),
        ("<= 36.12", "≤ 36.12"),
        (">= sqrt 2", "≥ √2"),
        ("192.8 MN*m/rad", "192.8 MN·m/rad"),
        ("D x 1e6 = 0.0040", "D × 10<sup>6</sup> = 0.0040"),
        ("4.05e-9", "4.05·10<sup>−9</sup>"),
        ("by +1.2e-4 when", "by +1.2·10<sup>−4</sup> when"),
        ("sha 12e4ab", "sha 12e4ab"),
        ("<script>F_c</script>", "&lt;script&gt;F<sub>c</sub>&lt;/script&gt;"),
        ("\"quoted\" & 'so'", "&quot;quoted&quot; &amp; &#x27;so&#x27;"),
    ],
)
def test_console_text_is_set(text, expected):
    assert typeset(text) == expected
