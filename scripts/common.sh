# Shared by ./run and ./test: what they need, how they install it, how they build and what they say meanwhile.
# Sourced by bash with the working directory at the project's root.

# The one list of Debian 12 packages. One line a purpose; the first word of each line says who needs it.
packages_for() {
    awk -v want=" $* " '!/^#/ && index(want, " " $1 " ") { for (i = 2; i <= NF; ++i) print $i }' scripts/packages.txt
}

# ccache then knows a compile again whatever the folder of the build and of the clone.
export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1

say() { printf '\n== %s\n' "$*"; }
fail() { printf '\n%s: %s\n' "${0##*/}" "$*" >&2; exit 1; }

on_debian_12() {
    [[ -r /etc/os-release ]] && (. /etc/os-release && [[ ${ID:-} == debian && ${VERSION_ID:-} == 12 ]])
}

# Installs the packages for the purposes named, unless they are there already. A second call asks dpkg and nothing else.
install_packages() {
    local wanted missing package
    wanted=$(packages_for "$@")
    if ! on_debian_12; then
        printf 'This is not Debian 12, so nothing is installed for you. What is needed, by its Debian names:\n'
        printf '%s\n' "$wanted" | sed 's/^/  /'
        return 0
    fi
    missing=()
    for package in $wanted; do
        [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || missing+=("$package")
    done
    if ((${#missing[@]} == 0)); then
        echo "All packages are there."
        return 0
    fi
    say "Installing ${#missing[@]} packages: ${missing[*]}"
    local -a as_root=()
    if ((EUID != 0)); then
        command -v sudo >/dev/null || fail "neither root nor sudo. Ask someone who is root to run:
  apt-get update && apt-get install -y --no-install-recommends ${missing[*]}"
        as_root=(sudo)
    fi
    local -a apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 -qq)
    "${apt[@]}" update || echo "apt-get update failed; trying with the package lists that are here."
    "${apt[@]}" install -y --no-install-recommends "${missing[@]}" >/dev/null ||
        fail "apt-get could not install: ${missing[*]}. Its own words are above."
}

# configure PRESET [cmake arguments...]: configures into build/PRESET, quietly when all is well.
configure() {
    local preset=$1 log
    shift
    log=build/$preset.configure.log
    mkdir -p build
    local -a options=(--preset "$preset")
    command -v ccache >/dev/null && options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
    # Newer compilers warn about more. Elsewhere than on the system we test on, a warning is no reason to stop.
    on_debian_12 || options+=(-DSUREFOOT_WERROR=OFF)
    cmake "${options[@]}" "$@" >"$log" 2>&1 || { cat "$log" >&2; fail "cmake could not configure '$preset'."; }
}

# build PRESET [targets...]: builds and shows ninja's progress.
build() {
    local preset=$1
    shift
    local -a targets=()
    (($#)) && targets=(--target "$@")
    cmake --build "build/$preset" "${targets[@]}" || fail "the build of '$preset' failed; see above."
}

# Calls a function and says how long it took.
timed() {
    local title=$1 begin=$SECONDS
    shift
    say "$title"
    "$@"
    echo "($((SECONDS - begin)) s)"
}
