#!/usr/bin/env python3
"""Does the core export only its own names, and lean on nothing that it promised to do without?

    scripts/check_symbols.py --shared libsurefoot.so --archive libsurefoot.a --commands compile_commands.json

The shared library exports names in surefoot::v0 alone and needs no library but the C++ runtime and Highway. The archive throws and
catches nothing, makes no type information, and takes nothing from libm but square roots, whose result the standard fixes to the
bit. Every source of the core is compiled with the flags that keep its answers the same everywhere.
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys

ALLOWED_LIBRARIES = re.compile(r"(libstdc\+\+|libm|libgcc_s|libc|libhwy|ld-linux[-\w]*)\.so")
OURS = re.compile(r"^(?:(?:typeinfo|typeinfo name|vtable|guard variable) for )?(?:[\w:<>*& ]+ )?surefoot::v0::")
FORBIDDEN = {
    "__cxa_throw": "throws", "__cxa_allocate_exception": "throws", "__cxa_begin_catch": "catches",
    "__cxa_rethrow": "rethrows", "__dynamic_cast": "casts by type information",
    "__tls_get_addr": "keeps a thread-local", "__cxa_thread_atexit": "keeps a thread-local",
}
REQUIRED_FLAGS = ("-ffp-contract=off", "-fno-fast-math", "-fno-exceptions", "-fno-rtti", "-fvisibility=hidden",
                  "-fvisibility-inlines-hidden", "-std=c++20")
FORBIDDEN_FLAGS = re.compile(r"-(Ofast|ffast-math|funsafe-math\S*|march=\S+|mfma|ffp-contract=fast)")


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def symbols(path, *options):
    """(kind, mangled name) of each symbol; nm's kinds: U is undefined, the rest are sections."""
    found = []
    for line in output_of("nm", *options, str(path)).splitlines():
        words = line.split()
        if len(words) >= 2 and not line.endswith(":"):
            found.append((words[-2], words[-1].split("@")[0]))
    return found


def demangle(names):
    done = subprocess.run(["c++filt"], input="\n".join(names), check=True, capture_output=True, text=True)
    return done.stdout.splitlines()


def check_shared(path):
    exported = sorted({name for kind, name in symbols(path, "-D", "--defined-only")})
    strangers = [name for name in demangle(exported) if not OURS.match(name)]
    complaints = [f"exports a name outside surefoot::v0: {name}" for name in strangers]
    if not exported:
        complaints.append("exports nothing")
    for line in output_of("readelf", "-d", str(path)).splitlines():
        needed = re.search(r"\(NEEDED\).*\[(.+)\]", line)
        if needed and not ALLOWED_LIBRARIES.match(needed.group(1)):
            complaints.append(f"needs {needed.group(1)}")
        if re.search(r"\((RPATH|RUNPATH)\)", line):
            complaints.append("carries a path of the machine that built it: " + line.strip())
    soname = re.search(r"SONAME.*\[(.+)\]", output_of("readelf", "-d", str(path)))
    print(f"{path.name}: {len(exported)} exported names, soname {soname.group(1) if soname else 'NONE'}")
    if not soname or not re.fullmatch(r"libsurefoot\.so\.\d+\.\d+", soname.group(1)):
        complaints.append("its soname is not libsurefoot.so.MAJOR.MINOR")
    return complaints


def libm_names():
    """What the C library's mathematics offers and C itself does not."""
    libraries = [output_of("g++", f"-print-file-name={name}").strip() for name in ("libm.so.6", "libc.so.6")]
    mathematics, plain_c = ({name for kind, name in symbols(path, "-D", "--defined-only")} for path in libraries)
    return mathematics - plain_c


def check_archive(path):
    complaints = []
    listed = symbols(path, "-A")
    undefined = {name for kind, name in listed if kind == "U"}
    defined = {name for kind, name in listed if kind not in "Uw"}
    for name in sorted(undefined):
        if name in FORBIDDEN:
            complaints.append(f"{FORBIDDEN[name]}: {name}")
    for name in sorted(defined):
        if name.startswith(("_ZTI", "_ZTS")) and "surefoot" in name:
            complaints.append(f"makes type information: {name}")
    for name in sorted((undefined - defined) & libm_names() - {"sqrt", "sqrtf"}):
        complaints.append(f"takes {name} from libm; only square roots give the same bits everywhere")
    print(f"{path.name}: {len(defined)} names defined, {len(undefined - defined)} taken from elsewhere")
    return complaints


def check_commands(path):
    complaints, count = [], 0
    for entry in json.loads(path.read_text(encoding="utf-8")):
        if not re.search(r"CMakeFiles/surefoot\.dir/", entry.get("output", entry["command"])):
            continue
        count += 1
        flags = entry["command"].split()
        missing = [flag for flag in REQUIRED_FLAGS if flag not in flags]
        bad = [flag for flag in flags if FORBIDDEN_FLAGS.fullmatch(flag)]
        if missing or bad:
            complaints.append(f"{entry['file']}: lacks {missing}, must not have {bad}")
    print(f"{path.name}: {count} sources of the core")
    if count == 0:
        complaints.append("lists no source of the core")
    return complaints


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--shared", type=pathlib.Path, required=True)
    parser.add_argument("--archive", type=pathlib.Path, required=True)
    parser.add_argument("--commands", type=pathlib.Path, required=True)
    arguments = parser.parse_args()
    complaints = [f"{path.name}: {complaint}" for path, check in
                  ((arguments.shared, check_shared), (arguments.archive, check_archive),
                   (arguments.commands, check_commands)) for complaint in check(path)]
    print("\n".join(complaints) or "as promised")
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
