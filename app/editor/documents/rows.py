"""The File menu as rows of the table of actions."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..actions import ActionRow, When, needs, when_open

if TYPE_CHECKING:
    from ..studio import Studio
    from .files import Files


@needs(lambda studio: "all is saved" if studio.is_open else when_open.why_not(studio))
def can_save(studio: Studio) -> bool:
    """Whether there is something that no folder holds yet."""
    return studio.is_open and (not studio.document.is_saved or studio.document.folder is None)


def file_rows(files: Files) -> tuple[ActionRow, ...]:
    """New, open, save."""
    return (
        ActionRow(
            "file.new",
            "New project…",
            "File",
            lambda _: files.ask_new(),
            "open",
            "Ctrl+N",
            "Make a project in a scenario of your choice",
            "plus-box-outline",
        ),
        ActionRow(
            "file.open",
            "Open…",
            "File",
            lambda _: files.choose(),
            "open",
            "Ctrl+O",
            "Open a project's folder",
            "folder-open-outline",
        ),
        ActionRow(
            "file.save",
            "Save",
            "File",
            lambda _: files.save(),
            "save",
            "Ctrl+S",
            "Save the project into its folder",
            "content-save-outline",
            can_save,
        ),
        ActionRow(
            "file.save_as",
            "Save as…",
            "File",
            lambda _: files.save_as(),
            "save",
            "Ctrl+Shift+S",
            "Save the project into another folder, and go on there",
            "content-save-edit-outline",
            when_open,
        ),
        ActionRow(
            "file.reload",
            "Reload…",
            "File",
            lambda _: files.ask_reload(),
            "save",
            tip="Go back to what the project's folder holds",
            icon="file-refresh-outline",
            enabled=When(
                lambda studio: studio.is_open and files.held.folder is not None,
                lambda studio: "save the project first" if studio.is_open else when_open.why_not(studio),
            ),
        ),
    )


def leaving_rows(files: Files) -> tuple[ActionRow, ...]:
    """Close and quit, which stand last."""
    return (
        ActionRow(
            "file.close",
            "Close project",
            "File",
            lambda _: files.close(),
            "close",
            "Ctrl+W",
            "Close the project and show the welcome page",
            "close",
            enabled=when_open,
        ),
        ActionRow(
            "file.quit",
            "Quit",
            "File",
            lambda _: files.quit(),
            "close",
            "Ctrl+Q",
            "Close the window",
            "exit-to-app",
        ),
    )
