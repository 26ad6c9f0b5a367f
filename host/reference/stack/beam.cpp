#include "reference/stack/beam.h"

#include "reference/stack/lobe_width.h"

namespace lacquer::reference {

double sum(const Energy& energy) {
    return energy.x + energy.y + energy.z + energy.w;
}

void LobeLight::add(const LobeLight& more) {
    const double here = sum(energy), there = sum(more.energy);
    if (there <= 0.0) return;
    width = (width * here + more.width * there) / (here + there);
    energy += more.energy;
}

void LobeLight::reflect(double alpha) {
    width = width_of_variance(variance_of_width(width) + variance_of_width(width_of_alpha(alpha)));
}

Energy Beam::energy() const {
    return through.energy + interfaces.energy + base.energy;
}

double Beam::alpha() const {
    LobeLight all = through;
    all.add(interfaces);
    all.add(base);
    return alpha_of_width(all.width);
}

void Beam::add(const Beam& more) {
    const double here = sum(energy()), there = sum(more.energy());
    if (there <= 0.0) return;
    cosine = (cosine * here + more.cosine * there) / (here + there);
    through.add(more.through);
    interfaces.add(more.interfaces);
    base.add(more.base);
}

void Beam::scale(const Energy& factor) {
    for_each_lobe([&](LobeLight& lobe) { lobe.energy *= factor; });
}

}  // namespace lacquer::reference
