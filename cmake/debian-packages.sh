# Sourced by demos/try.sh and tests/run.sh: installs the Debian packages that are missing, as root or through sudo.

library_packages="g++ cmake ninja-build ccache pkg-config
    libompl-dev libgdal-dev libeigen3-dev libboost-dev libgeographiclib-dev libcairo2-dev nlohmann-json3-dev"
demo_packages="libcli11-dev libspdlog-dev fonts-dejavu-core"
test_packages="libgtest-dev librapidcheck-dev libbenchmark-dev python3-gdal gmt-gshhg-full
    ompl-demos python3-matplotlib"

# install_packages NAME...
install_packages()
{
    missing=""
    for package in "$@"; do
        dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q "install ok installed" || missing="$missing $package"
    done
    [ -z "$missing" ] && return 0

    as_root=""
    if [ "$(id -u)" -ne 0 ]; then
        if ! command -v sudo >/dev/null; then
            echo "Missing Debian packages:$missing" >&2
            echo "Install them as root (apt-get install$missing) and run this again." >&2
            return 1
        fi
        as_root="sudo"
    fi
    echo "Installing Debian packages:$missing"
    $as_root apt-get update -qq &&
        $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null
}
