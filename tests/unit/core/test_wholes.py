"""What is done as a whole: whoever would end the program asks whether something is."""

from app.core.wholes import as_a_whole, may_be_cut_off


def test_nothing_is_cut_off_as_long_as_one_thing_is_done_as_a_whole() -> None:
    assert may_be_cut_off()
    with as_a_whole():
        with as_a_whole():
            assert not may_be_cut_off()
        assert not may_be_cut_off()
    assert may_be_cut_off()


def test_what_fails_halfway_is_over() -> None:
    try:
        with as_a_whole():
            raise ValueError
    except ValueError:
        assert may_be_cut_off()
