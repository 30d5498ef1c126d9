"""What is said of how well a behavior fits its examples."""

from app.editor.library.fits import Fit


def test_thousands_are_told_apart() -> None:
    assert Fit(learned_from=2_000, share=1.0).brief == "fits all 2,000 examples"
    many = Fit(learned_from=4_000, share=0.5, conflicts=1_200, left_out=1_000)
    assert many.words == (
        "fits 50% of 4,000 examples; 1,000 cannot be learned from; "
        "1,200 contradict each other: equal features, another label"
    )
