// SPDX-License-Identifier: GPL-3.0-or-later
//
// ncsim-mpi run: the same outputs as `ncsim run`, with one tile a rank. Ranks cut as --tile does,
// and rank 0 combines the tiles as merge does. This file only transfers data between ranks.
#include "ncsim/base/plain_text.h"
#include "ncsim/report/tile_file.h"
#include "ncsim/setup/digest.h"

#include "commands/options.h"
#include "merge/merge_tiles.h"
#include "run/mesh_folder.h"
#include "run/run.h"
#include "run/tile.h"
#include "system/console.h"

#include <fmt/format.h>
#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <mutex>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

namespace {

using namespace ncsim;

// MPI counts in int.
constexpr std::size_t kMostAtOnce = std::size_t{1} << 30;

void send(const std::string& bytes, int to) {
    const std::uint64_t size = bytes.size();
    MPI_Send(&size, 1, MPI_UINT64_T, to, 0, MPI_COMM_WORLD);
    for (std::size_t at = 0; at < bytes.size(); at += kMostAtOnce) {
        const auto count = static_cast<int>(std::min(kMostAtOnce, bytes.size() - at));
        MPI_Send(bytes.data() + at, count, MPI_BYTE, to, 0, MPI_COMM_WORLD);
    }
}

std::string receive(int from) {
    std::uint64_t size = 0;
    MPI_Recv(&size, 1, MPI_UINT64_T, from, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    std::string bytes(size, '\0');
    for (std::size_t at = 0; at < bytes.size(); at += kMostAtOnce) {
        const auto count = static_cast<int>(std::min(kMostAtOnce, bytes.size() - at));
        MPI_Recv(bytes.data() + at, count, MPI_BYTE, from, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    }
    return bytes;
}

// Request of rank 0 to a different rank.
enum class Request : std::uint8_t { Tile, Nothing };

void ask(Request what, int rank) {
    const auto word = static_cast<std::uint8_t>(what);
    MPI_Send(&word, 1, MPI_UINT8_T, rank, 0, MPI_COMM_WORLD);
}

// Sends the tile to rank 0 at each request, until rank 0 is finished; for all ranks except 0.
// Sleeps between polls, because MPI_Recv would busy-wait and take processor time from working
// ranks.
void serve(const std::string& tile) {
    while (true) {
        for (int is_there = 0; is_there == 0;) {
            MPI_Iprobe(0, 0, MPI_COMM_WORLD, &is_there, MPI_STATUS_IGNORE);
            if (is_there == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        std::uint8_t word = 0;
        MPI_Recv(&word, 1, MPI_UINT8_T, 0, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
        if (static_cast<Request>(word) == Request::Nothing) return;
        send(tile, 0);
    }
}

// Combines the tiles of all ranks, on rank 0. Receives each tile when needed and keeps none.
int combine_tiles(app::Options options, std::optional<report::TileFile> own, int ranks) {
    std::vector<report::TileFile> files;
    std::vector<std::string> names;
    bool is_cut = own.has_value();
    const std::string tile = own ? std::exchange(own->tile, {}) : std::string();
    for (int rank = 0; rank < ranks; ++rank) {
        names.push_back(fmt::format("rank {}", rank));
        if (rank == 0) {
            files.push_back(own ? std::move(*own) : report::TileFile{});
            continue;
        }
        std::string bytes = receive(rank);
        is_cut = is_cut && !bytes.empty();
        files.push_back(
            is_cut ? report::tile_file_from(std::move(bytes), names.back(), setup::digest_of)
                   : report::TileFile{});
    }
    // run() reports the faults of the program.
    if (!is_cut) return run(std::move(options));
    const std::vector<std::size_t> order = report::order_tiles(files, names);
    // MPI is initialised for one calling thread at a time.
    std::mutex asking;
    return app::run_of_tiles(std::move(options), files, order, [&](std::size_t number) {
        const auto rank = static_cast<int>(order[number]);
        if (rank == 0) return std::string(tile);
        const std::scoped_lock lock(asking);
        ask(Request::Tile, rank);
        return receive(rank);
    });
}

int run(app::Options options, int rank, int ranks) {
    if (!options.tile.empty()) throw std::runtime_error("--tile: ranks are tiles");
    if (options.model != cda::kTiledModel || !options.step.empty() || !options.sections.empty() ||
        !options.save_stock.empty() || app::has_frames(options) || !options.html.empty() ||
        options.block_volumes)
        throw std::runtime_error(
            "--step, --section, --save-stock, --frames, --gif, --apng, --html, --block-volumes and "
            "other "
            "models do not know tiles: ncsim run");
    if (options.program == "-") throw std::runtime_error("the program has to have a name");
    app::Options of_tile = options;
    of_tile.number = {static_cast<std::uint32_t>(rank), static_cast<std::uint32_t>(ranks)};
    // Ranks share the processors of a machine.
    of_tile.threads = std::max(1U, options.threads);
    setup::InputSet inputs;
    std::optional<report::TileFile> tile = app::cut_tile(of_tile, inputs, false);
    if (rank > 0) {
        const std::string bytes = tile ? std::exchange(tile->tile, {}) : std::string();
        send(tile ? report::bytes_of(*tile, setup::digest_of) : std::string(), 0);
        serve(bytes);
        return app::kClean;
    }
    if (!options.gltf.empty() && app::names_a_folder(options.gltf))
        options.mesh_folder = std::exchange(options.gltf, {});
    const int code = combine_tiles(std::move(options), std::move(tile), ranks);
    for (int other = 1; other < ranks; ++other)
        ask(Request::Nothing, other);
    return code;
}

// Only rank 0 prints the text.
int print_once(const app::EarlyExit& early_exit, int rank) {
    if (rank == 0) {
        if (early_exit.exit_code == app::kClean) {
            app::put_text(early_exit.text);
        } else {
            app::print_error(early_exit.text);
        }
    }
    return early_exit.exit_code;
}

// Aborts all ranks, because the remaining ranks would wait for this rank.
[[noreturn]] void end_all(int rank, const std::string& why, int code) {
    app::print_error(fmt::format("ncsim-mpi: rank {}: {}\n", rank, one_line(why)));
    MPI_Abort(MPI_COMM_WORLD, code);
    std::terminate();
}

}  // namespace

int main(int argc, char** argv) {
    int threads = MPI_THREAD_SINGLE;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_SERIALIZED, &threads);
    int rank = 0, ranks = 1;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    int code = app::kEnvironment;
    try {
        app::Command command =
            app::parse_options(std::vector<std::string>(argv + (argc > 0 ? 1 : 0), argv + argc));
        if (auto* options = std::get_if<app::Options>(&command)) {
            if (threads < MPI_THREAD_SERIALIZED) options->threads = 1;
            code = run(std::move(*options), rank, ranks);
        } else if (const auto* early_exit = std::get_if<app::EarlyExit>(&command)) {
            code = print_once(*early_exit, rank);
        } else {
            code =
                print_once({app::kEnvironment, "ncsim-mpi: there is only ncsim-mpi run\n"}, rank);
        }
    } catch (const std::bad_alloc&) {
        end_all(rank, "out of memory", app::kEnvironment);
    } catch (const std::logic_error& e) {
        end_all(rank, std::string("a bug of ours, please report it: ") + e.what(),
                app::kInternalError);
    } catch (const std::exception& e) {
        end_all(rank, e.what(), app::kEnvironment);
    }
    MPI_Finalize();
    return code;
}
