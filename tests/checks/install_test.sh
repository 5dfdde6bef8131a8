#!/usr/bin/env bash
# Installs a build into an empty folder and builds small outside programs against it, with CMake and with pkg-config.
#
#     install_test.sh BUILD_FOLDER static|shared
set -euo pipefail
build=$1 kind=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
tree=$scratch/moved

echo "== Installing ($kind)"
cmake --install "$build" --prefix "$scratch/installed" >"$scratch/install.log"
# Whatever finds its way only through the folder it was installed to does not survive this.
mv "$scratch/installed" "$tree"
library=$(find "$tree" -name "libsurefoot.$([[ $kind == shared ]] && echo so || echo a)")
[[ -n $library ]] || { echo "no $kind library was installed"; exit 1; }
cd "$scratch"

echo "== Outside programs with find_package(surefoot)"
cmake -S "$here/outsider" -B with_cmake -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$tree" >configure.log ||
    { cat configure.log; exit 1; }
cmake --build with_cmake >build.log || { cat build.log; exit 1; }
with_cmake/outsider
if [[ -d $tree/include/surefoot && -f $tree/include/surefoot/import.hpp ]]; then
    # The helper program is looked for where the library was to be installed; this tree has moved.
    SUREFOOT_IMPORTER=$(find "$tree" -name surefoot-importer) with_cmake/importing_outsider
fi
if [[ -f $tree/include/surefoot/navigation_mesh.hpp ]]; then
    with_cmake/navigating_outsider
fi

echo "== A component that does not exist is refused in words"
if cmake -S "$here/outsider" -B refused -DCMAKE_PREFIX_PATH="$tree" -DSUREFOOT_OUTSIDER_COMPONENT=wings >refused.log 2>&1; then
    echo "find_package(surefoot COMPONENTS wings) should have failed"; exit 1
fi
grep -q "without its component 'wings'" refused.log || { cat refused.log; exit 1; }

echo "== An outside program with pkg-config"
PKG_CONFIG_PATH=$(dirname "$(find "$tree" -name surefoot.pc)")
export PKG_CONFIG_PATH
[[ $(pkg-config --modversion surefoot) == "$(sed -n 's/^project(surefoot VERSION \([0-9.]*\) .*/\1/p' "$here/../../CMakeLists.txt")" ]]
read -ra flags <<<"$(pkg-config --cflags --libs surefoot)"
for exceptions in "" "-fno-exceptions -fno-rtti"; do
    # shellcheck disable=SC2086  # none, or two options
    g++ -std=c++20 $exceptions "$here/outsider/main.cpp" "${flags[@]}" -o with_pkg_config
    LD_LIBRARY_PATH=$(dirname "$library") ./with_pkg_config
done

if [[ -x $tree/bin/surefoot ]]; then
    echo "== The installed program"
    "$tree/bin/surefoot" --help >/dev/null
fi

if [[ -x $tree/bin/surefoot-platformer ]]; then
    echo "== The installed platformer finds its levels and its importer, wherever the tree was moved to"
    levels=$tree/share/surefoot/levels/platformer
    [[ -f $levels/campaign.txt && $(find "$levels" -type f | grep -vc '\.glb$') == 1 ]] || { ls -R "$levels"; exit 1; }
    cp "$levels/first-steps.glb" "$levels/only-here.glb"
    env -u SUREFOOT_IMPORTER -u SUREFOOT_PLATFORMER_LEVELS "$tree/bin/surefoot-platformer" only-here --headless --frames 5
fi
