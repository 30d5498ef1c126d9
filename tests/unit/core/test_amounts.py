"""Amounts as people write them."""

import pytest

from app.core.amounts import exact


@pytest.mark.parametrize(
    ("value", "written"),
    [(100000.0, "100,000"), (0.25, "0.25"), (1234.5678, "1,234.5678"), (2**63, "9,223,372,036,854,775,808")],
)
def test_a_limit_is_written_with_all_digits_and_no_needless_point(value: float, written: str) -> None:
    assert exact(value) == written
