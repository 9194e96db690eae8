import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from coupling_design.report.page.envelope import COARSE_BINS, bins_around, extremes

SIGNALS = arrays(
    np.float64,
    st.integers(2, 6000),
    elements=st.floats(-1e6, 1e6),
    fill=st.floats(-1, 1),
)
MOMENTS = st.lists(st.floats(-1, 13), max_size=3)


def over_12_s(signal):
    return np.linspace(0.0, 12.0, len(signal))


@given(SIGNALS, MOMENTS)
def test_no_peak_is_lost(signal, moments):
    drawn = signal[extremes(signal, bins_around(over_12_s(signal), moments))]
    assert drawn.max() == signal.max()
    assert drawn.min() == signal.min()


@given(SIGNALS, MOMENTS)
def test_no_peak_of_any_bin_is_lost(signal, moments):
    bins = bins_around(over_12_s(signal), moments)
    drawn = extremes(signal, bins)
    for first, last in zip(bins.edges[:-1], bins.edges[1:], strict=True):
        inside = signal[drawn[(drawn >= first) & (drawn < last)]]
        assert inside.max() == signal[first:last].max()
        assert inside.min() == signal[first:last].min()


@given(SIGNALS, MOMENTS)
def test_bins_cover_every_sample_once(signal, moments):
    edges = bins_around(over_12_s(signal), moments).edges
    assert edges[0] == 0
    assert edges[-1] == len(signal)
    assert (np.diff(edges) > 0).all()


@given(SIGNALS, MOMENTS)
def test_samples_are_drawn_in_order_both_ends_among_them(signal, moments):
    drawn = extremes(signal, bins_around(over_12_s(signal), moments))
    assert (np.diff(drawn) > 0).all()
    assert (drawn[0], drawn[-1]) == (0, len(signal) - 1)


@pytest.fixture
def long():
    return np.linspace(0.0, 12.0, 120_000, endpoint=False)


def test_a_long_signal_becomes_short(long):
    drawn = extremes(np.sin(1e5 * long), bins_around(long, [9.0]))
    assert len(drawn) < 4 * COARSE_BINS


def test_bins_are_finer_around_the_resonance(long):
    widths = np.diff(bins_around(long, [9.0]).edges)
    at = long[bins_around(long, [9.0]).edges[:-1]]
    near = (at > 8.5) & (at < 9.5)
    assert widths[near].max() * 8 == widths[~near].max()


def test_the_words_say_how_wide_the_bins_are(long):
    note = bins_around(long, [9.0]).note
    assert "every 24.0 ms (3.00 ms from 8.40 to 9.60 s)" in note
    assert "120000 samples" in note


def test_a_short_signal_is_drawn_whole():
    time = np.linspace(0, 1, 300)
    bins = bins_around(time, [0.5])
    assert bins.note == "All 300 samples are drawn."
    assert len(extremes(np.sin(time), bins)) == 300
