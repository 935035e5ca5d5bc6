// SPDX-License-Identifier: GPL-3.0-or-later
//
// read_3mf <folder>: reads every .3mf in the folder with lib3mf. Each file must be read without
// warnings, as a closed and oriented mesh with the volume in the adjacent .expect file, of which
// each vertex is used.
#include <Model/COM/NMR_DLLInterfaces.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace NMR;

void ask(LIB3MFRESULT result, const char* question) {
    if (result != 0) throw std::runtime_error(std::string("lib3mf does not answer: ") + question);
}

double expected_volume(const std::filesystem::path& path) {
    std::ifstream in(path);
    std::string word;
    double volume = 0.0;
    in >> word >> volume;
    return volume;
}

double volume_of(PLib3MFModelMeshObject* mesh) {
    DWORD vertex_count = 0;
    DWORD triangle_count = 0;
    ask(lib3mf_meshobject_getvertexcount(mesh, &vertex_count), "number of vertices");
    ask(lib3mf_meshobject_gettrianglecount(mesh, &triangle_count), "number of triangles");
    std::vector<MODELMESHVERTEX> vertices(vertex_count);
    for (DWORD i = 0; i < vertex_count; ++i) {
        ask(lib3mf_meshobject_getvertex(mesh, i, &vertices[i]), "vertex");
    }
    // Subtracts the first vertex because lib3mf has floats.
    const auto coordinate = [&](DWORD vertex, int axis) {
        return static_cast<double>(vertices[vertex].m_fPosition[axis]) -
               static_cast<double>(vertices[0].m_fPosition[axis]);
    };
    std::vector<bool> is_used(vertex_count, false);
    double sixfold = 0.0;
    for (DWORD i = 0; i < triangle_count; ++i) {
        MODELMESHTRIANGLE t{};
        ask(lib3mf_meshobject_gettriangle(mesh, i, &t), "triangle");
        for (const DWORD v : t.m_nIndices)
            is_used[v] = true;
        for (int x = 0; x < 3; ++x) {
            const int y = (x + 1) % 3;
            const int z = (x + 2) % 3;
            sixfold += coordinate(t.m_nIndices[0], x) *
                       (coordinate(t.m_nIndices[1], y) * coordinate(t.m_nIndices[2], z) -
                        coordinate(t.m_nIndices[1], z) * coordinate(t.m_nIndices[2], y));
        }
    }
    if (std::ranges::find(is_used, false) != is_used.end())
        throw std::runtime_error("a vertex is not used");
    return sixfold / 6.0;
}

void check(const std::filesystem::path& path) {
    PLib3MFModel* model = nullptr;
    PLib3MFModelReader* reader = nullptr;
    ask(lib3mf_createmodel(&model), "a model");
    ask(lib3mf_model_queryreader(model, "3mf", &reader), "a reader");
    ask(lib3mf_reader_readfromfileutf8(reader, path.c_str()), "the file");
    DWORD warnings = 0;
    ask(lib3mf_reader_getwarningcount(reader, &warnings), "warnings");
    if (warnings != 0) throw std::runtime_error(std::to_string(warnings) + " warnings");

    PLib3MFModelResourceIterator* meshes = nullptr;
    ask(lib3mf_model_getmeshobjects(model, &meshes), "meshes");
    double volume = 0.0;
    int count = 0;
    BOOL has_next = 0;
    while (lib3mf_resourceiterator_movenext(meshes, &has_next) == 0 && has_next != 0) {
        PLib3MFModelResource* mesh = nullptr;
        ask(lib3mf_resourceiterator_getcurrent(meshes, &mesh), "a mesh");
        BOOL is_closed = 0;
        ask(lib3mf_meshobject_ismanifoldandoriented(mesh, &is_closed), "whether it is closed");
        if (is_closed == 0) throw std::runtime_error("the mesh is not closed and oriented");
        volume += volume_of(mesh);
        lib3mf_release(mesh);
        ++count;
    }
    lib3mf_release(meshes);
    lib3mf_release(reader);
    lib3mf_release(model);
    const double expected =
        expected_volume(std::filesystem::path(path).replace_extension(".expect"));
    if (count != (expected > 0.0 ? 1 : 0)) throw std::runtime_error("not one mesh");
    if (std::abs(volume - expected) > 1e-4 * expected) {
        throw std::runtime_error("volume " + std::to_string(volume));
    }
    std::cout << path << ": " << volume << " mm³\n";
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return EXIT_FAILURE;
    int files = 0;
    bool good = true;
    for (const auto& entry : std::filesystem::directory_iterator(argv[1])) {
        if (entry.path().extension() != ".3mf") continue;
        ++files;
        try {
            check(entry.path());
        } catch (const std::exception& e) {
            std::cerr << entry.path() << ": " << e.what() << '\n';
            good = false;
        }
    }
    return good && files > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
