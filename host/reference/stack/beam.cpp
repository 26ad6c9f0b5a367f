#include "reference/stack/beam.h"

namespace lacquer::reference {

double sum(const Energy& energy) {
    return energy.x + energy.y + energy.z + energy.w;
}

void LobeLight::add(const Energy& more, double more_variance) {
    const double here = sum(energy), there = sum(more);
    if (there <= 0.0) return;
    // Variances of wide lobes have no bound, but their widths on the disk do, and these are what
    // averages: alpha^1.1, about in proportion to the square of that width.
    const double width =
        (variance / (1.0 + variance) * here + more_variance / (1.0 + more_variance) * there) /
        (here + there);
    variance = width / (1.0 - width);
    energy += more;
}

Energy Beam::energy() const {
    Energy all{0.0};
    for (const LobeLight& lobe : lobes) all += lobe.energy;
    return all;
}

LobeShape Beam::shape() const {
    LobeLight all;
    for (const LobeLight& lobe : lobes) all.add(lobe.energy, lobe.variance);
    return {sine, all.variance};
}

void Beam::add(const Beam& more) {
    const double here = sum(energy()), there = sum(more.energy());
    if (there <= 0.0) return;
    sine = (sine * here + more.sine * there) / (here + there);
    for (std::size_t n = 0; n < lobes.size(); ++n)
        lobes[n].add(more.lobes[n].energy, more.lobes[n].variance);
}

}  // namespace lacquer::reference
