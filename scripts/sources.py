"""Which files of the project are source code: those that git knows or would add, so that build folders never count."""

import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent


def project_files(suffixes, root=ROOT):
    """Paths relative to `root` of all files with one of these suffixes, sorted."""
    if (root / ".git").exists():
        listed = subprocess.run(
            ["git", "-c", f"safe.directory={root}", "ls-files", "--cached", "--others", "--exclude-standard"],
            cwd=root, check=True, capture_output=True, text=True).stdout.splitlines()
        paths = [pathlib.PurePosixPath(line) for line in listed]
    else:  # an unpacked archive
        paths = [pathlib.PurePosixPath(path.relative_to(root)) for path in root.rglob("*")
                 if path.is_file() and path.relative_to(root).parts[0] not in ("build", "out")]
    return sorted({path for path in paths if path.suffix in suffixes and (root / path).is_file()})
