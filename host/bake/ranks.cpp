#include "bake/ranks.h"

#include <cstdlib>
#include <exception>

#ifdef LACQUER_HAS_MPI
#include <mpi.h>
#endif

namespace lacquer::bake {

#ifdef LACQUER_HAS_MPI

Ranks::Ranks() {
    // Opening MPI alone takes a second and may try the network: only where mpirun asks for it.
    if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr) return;
    MPI_Init(nullptr, nullptr);
    opened_ = true;
    int rank = 0, count = 1;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &count);
    rank_ = static_cast<std::size_t>(rank);
    count_ = static_cast<std::size_t>(count);
}

Ranks::~Ranks() {
    // A process that fails leaves without closing: mpirun then ends the others, which would wait.
    if (opened_ && std::uncaught_exceptions() == 0) MPI_Finalize();
}

void Ranks::gather(std::span<float> values) const {
    if (count_ == 1) return;
    MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_FLOAT, MPI_SUM,
                  MPI_COMM_WORLD);
}

#else

Ranks::Ranks() = default;
Ranks::~Ranks() = default;
void Ranks::gather(std::span<float>) const {}

#endif

}  // namespace lacquer::bake
