"""The one tree of errors. Each message says what is wrong, where, and what is allowed."""


class UnderstudyError(Exception):
    """Root of everything that a user can mend; the command line prints its message and exits with 2."""


class BindingError(UnderstudyError):
    """A parameter of a behavior or feature is open, or bound to something that does not exist there."""


class LibraryError(UnderstudyError):
    """A library breaks a rule: recursion, a missing behavior, a name used twice."""


class HierarchyError(UnderstudyError):
    """A forest of controllers breaks a rule: unknown types, a node in two places, an empty group."""


class ExampleError(UnderstudyError):
    """Examples cannot be learned from: none are there, or a value is not a finite number."""


class EditError(UnderstudyError):
    """An edit names something that is not there, or would break the project."""


class StorageError(UnderstudyError):
    """A file cannot be read or written; the message names the file and the place in it."""


class ScenarioError(UnderstudyError):
    """A scenario is unknown, lacks something that a project uses, or one of its functions raised."""


class ParameterError(UnderstudyError):
    """A parameter of a scenario, arm or experiment is unknown or out of its range."""


class SessionError(UnderstudyError):
    """A command came at a moment or for a node where it cannot be obeyed."""


class ProgramError(UnderstudyError):
    """Behaviors cannot be turned into the flat tables that the compiled kernel steps; the reference engine runs them."""


class UncompilableError(ScenarioError):
    """A scenario cannot be compiled; the reference engine runs it all the same."""
