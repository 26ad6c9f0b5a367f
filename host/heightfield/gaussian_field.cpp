#include "heightfield/gaussian_field.h"

#include <fftw3.h>
#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <memory>
#include <mutex>
#include <numbers>

#include "core/error.h"
#include "simulator/sampling.h"

namespace lacquer::heightfield {

namespace {

constexpr double kPi = std::numbers::pi;

// Waves per period and correlation length beyond which the spectrum, exp(-(pi waves)^2), is below
// the rounding of what it is added to. Less than half of kMinCellsPerLength.
constexpr double kMaxWavesPerLength = 1.95;

// The power of each wave of a period: a product of one factor per axis, as the autocorrelation is.
class Spectrum {
 public:
    explicit Spectrum(double period_lengths)
        : period_{period_lengths},
          max_waves_{static_cast<int>(std::floor(kMaxWavesPerLength * period_lengths))} {
        for (int waves = -max_waves_; waves <= max_waves_; ++waves) axis_sum_ += factor(waves);
    }

    int max_waves() const { return max_waves_; }

    double factor(int waves) const {
        const double x = kPi * waves / period_;
        return std::exp(-x * x);
    }

    double axis_sum() const { return axis_sum_; }

    // All waves but the constant one, whose power moves the surface up and down only.
    double total() const { return axis_sum_ * axis_sum_ - 1.0; }

 private:
    double period_;
    int max_waves_;
    double axis_sum_ = 0.0;
};

struct FreeFftw {
    void operator()(void* memory) const { fftw_free(memory); }
};

struct DestroyPlan {
    void operator()(fftw_plan plan) const;
};

using Waves = std::unique_ptr<fftw_complex[], FreeFftw>;
using Plan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, DestroyPlan>;

// FFTW plans from one thread at a time.
std::mutex& planner() {
    static std::mutex mutex;
    return mutex;
}

void DestroyPlan::operator()(fftw_plan plan) const {
    const std::lock_guard lock{planner()};
    fftw_destroy_plan(plan);
}

// The half plane of waves along x >= 0 that a real field needs, row by row of waves along y.
class HalfPlane {
 public:
    explicit HalfPlane(int cells) : cells_{cells}, columns_{cells / 2 + 1} {
        const auto count = static_cast<std::size_t>(cells_) * static_cast<std::size_t>(columns_);
        waves_.reset(fftw_alloc_complex(count));
        for (std::size_t n = 0; n < count; ++n) waves_[n][0] = waves_[n][1] = 0.0;
    }

    void set(int along_x, int along_y, const std::complex<double>& amplitude) {
        const int row = along_y < 0 ? along_y + cells_ : along_y;
        fftw_complex& wave =
            waves_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                   static_cast<std::size_t>(along_x)];
        wave[0] = amplitude.real();
        wave[1] = amplitude.imag();
    }

    // Sums the waves; destroys them.
    std::vector<double> field() {
        std::vector<double> heights(static_cast<std::size_t>(cells_) *
                                    static_cast<std::size_t>(cells_));
        Plan plan;
        {
            const std::lock_guard lock{planner()};
            plan.reset(
                fftw_plan_dft_c2r_2d(cells_, cells_, waves_.get(), heights.data(), FFTW_ESTIMATE));
        }
        fftw_execute(plan.get());
        return heights;
    }

 private:
    int cells_, columns_;
    Waves waves_;
};

}  // namespace

void require_grid(const FieldGrid& grid) {
    if (grid.cells < kMinCells || grid.cells > kMaxCells)
        throw Error{fmt::format("a heightfield of {} cells along a side: must be in [{}, {}]",
                                grid.cells, kMinCells, kMaxCells)};
    const double most = grid.cells / kMinPeriodLengths;
    if (!(grid.cells_per_length >= kMinCellsPerLength && grid.cells_per_length <= most))
        throw Error{
            fmt::format("a heightfield of {} cells per correlation length: must be in [{}, {}] "
                        "where a side has "
                        "{} cells",
                        grid.cells_per_length, kMinCellsPerLength, most, grid.cells)};
}

std::vector<double> gaussian_field(const FieldGrid& grid, simulator::RandomStream& random) {
    require_grid(grid);
    const Spectrum spectrum{grid.period_lengths()};
    HalfPlane waves{grid.cells};
    for (int along_x = 0; along_x <= spectrum.max_waves(); ++along_x)
        for (int along_y = -spectrum.max_waves(); along_y <= spectrum.max_waves(); ++along_y) {
            // Of the waves along y alone, those of negative number are the others' conjugates.
            if (along_x == 0 && along_y <= 0) continue;
            const simulator::BellPair bell = simulator::sample_bell_pair(random);
            const double power =
                spectrum.factor(along_x) * spectrum.factor(along_y) / spectrum.total();
            const auto amplitude = std::sqrt(power) * std::complex{bell.x, bell.y};
            waves.set(along_x, along_y, amplitude);
            if (along_x == 0) waves.set(0, -along_y, std::conj(amplitude));
        }
    return waves.field();
}

double step_variance(const FieldGrid& grid) {
    require_grid(grid);
    const Spectrum spectrum{grid.period_lengths()};
    double sum = 0.0;
    for (int waves = -spectrum.max_waves(); waves <= spectrum.max_waves(); ++waves) {
        const double half_step = std::sin(kPi * waves / grid.cells);
        sum += spectrum.factor(waves) * 4.0 * half_step * half_step;
    }
    return sum * spectrum.axis_sum() / spectrum.total();
}

}  // namespace lacquer::heightfield
