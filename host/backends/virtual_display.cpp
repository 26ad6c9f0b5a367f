#include "backends/virtual_display.h"

#include <boost/process.hpp>

#include "core/error.h"

namespace lacquer {

namespace bp = boost::process;

struct VirtualDisplay::Impl {
    bp::ipstream number;  // Xvfb writes the number of the display that it found free
    bp::child server;
    std::string name;
};

VirtualDisplay::VirtualDisplay() : impl_{std::make_unique<Impl>()} {
    const std::filesystem::path program = require_xvfb();
    impl_->server = bp::child{bp::exe = program.string(),
                              bp::args = {"-displayfd", "1", "-screen", "0", "64x64x24"},
                              bp::std_out > impl_->number, bp::std_err > bp::null};
    std::string number;
    if (!std::getline(impl_->number, number) || number.empty())
        throw Error{"Xvfb does not start: no display is free"};
    impl_->name = ":" + number;
}

VirtualDisplay::~VirtualDisplay() {
    std::error_code ignored;  // it may be gone already
    impl_->server.terminate(ignored);
}

const std::string& VirtualDisplay::name() const {
    return impl_->name;
}

std::filesystem::path require_xvfb() {
    const auto found = bp::search_path("Xvfb");
    if (found.empty()) throw Unavailable{"Xvfb is missing", "apt-get install xvfb"};
    return found.string();
}

}  // namespace lacquer
