"""What the library raises, one class for each kind of failure."""


class Error(Exception):
    """Base of everything that this module raises. The text is one line that names the remedy."""

    def __str__(self) -> str:
        return ' '.join(super().__str__().splitlines())  # names in it may hold ends of lines


class UsageError(Error, ValueError):
    """A setting or an argument that cannot be."""


class InputError(Error, ValueError):
    """A file, a grid or an array that cannot be used."""


class DeviceError(Error, RuntimeError):
    """No usable Vulkan device, or one that was lost. The next picture may open another."""


class OutputError(Error, OSError):
    """A file that cannot be written."""


class FoundError(Error):
    """What was looked for was found, where finding it is bad news."""


class CancelledError(Error):
    """Work that was stopped."""


class OutOfMemoryError(Error, MemoryError):
    """Too little memory, of the machine or of the device."""


class InternalError(Error, RuntimeError):
    """A mistake of the library's."""


class VprobeWarning(UserWarning):
    """What the library warns of, such as a sheet that misses the grid."""


# In the order of the library's ErrorKind.
BY_KIND = (
    UsageError, InputError, DeviceError, OutputError, FoundError, CancelledError, OutOfMemoryError, InternalError)
