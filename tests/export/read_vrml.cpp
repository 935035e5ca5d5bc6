// SPDX-License-Identifier: GPL-3.0-or-later
//
// read_vrml <folder>: reads every .wrl in the folder with Coin. Each file must enclose the volume
// in the adjacent .expect file, and have a group for each program line and the motions listed
// there.
#include <Inventor/SoDB.h>
#include <Inventor/SoPrimitiveVertex.h>
#include <Inventor/VRMLnodes/SoVRMLGroup.h>
#include <Inventor/VRMLnodes/SoVRMLInterpolator.h>
#include <Inventor/VRMLnodes/SoVRMLTransform.h>
#include <Inventor/actions/SoCallbackAction.h>
#include <Inventor/errors/SoReadError.h>
#include <Inventor/nodes/SoNode.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace {

// Expected place of a node that an interpolator drives, at a fraction of the cycle.
struct Moved {
    bool turns = false;
    std::string interpolator, node;
    float fraction = 0.0F;
    float x = 0.0F, y = 0.0F, z = 0.0F, degrees = 0.0F;
};

struct Expectation {
    double volume = 0.0;
    std::vector<std::string> groups;  // names
    std::vector<Moved> moved;
};

Expectation read_expectation(const std::filesystem::path& path) {
    std::ifstream in(path);
    Expectation result;
    std::string word;
    in >> word >> result.volume >> word;
    for (unsigned line = 0; in >> line;) {
        result.groups.push_back(line == 0 ? "STOCK" : "LINE_" + std::to_string(line));
    }
    in.clear();
    while (in >> word) {
        if (word != "turned" && word != "shifted") continue;
        Moved moved;
        moved.turns = word == "turned";
        in >> moved.interpolator >> moved.fraction >> moved.node >> moved.x >> moved.y >> moved.z;
        if (moved.turns) in >> moved.degrees;
        result.moved.push_back(moved);
    }
    return result;
}

bool reported_error = false;

// Sums the volumes of tetrahedra over the first vertex. Far from the origin, floats are too coarse
// for tetrahedra over the origin.
struct VolumeSum {
    bool has_apex = false;
    SbVec3f apex;
    double sixfold = 0.0;
};

void add_triangle(void* data, SoCallbackAction*, const SoPrimitiveVertex* a,
                  const SoPrimitiveVertex* b, const SoPrimitiveVertex* c) {
    auto* sum = static_cast<VolumeSum*>(data);
    if (!sum->has_apex) sum->apex = a->getPoint();
    sum->has_apex = true;
    const SbVec3f p = a->getPoint() - sum->apex;
    const SbVec3f q = b->getPoint() - sum->apex;
    const SbVec3f r = c->getPoint() - sum->apex;
    sum->sixfold += static_cast<double>(p.dot(q.cross(r)));
}

// True if the interpolator moves the node through its routes, as when the clock runs.
bool is_moved(const Moved& moved) {
    SoNode* interpolator = SoNode::getByName(SbName(moved.interpolator.c_str()));
    SoNode* node = SoNode::getByName(SbName(moved.node.c_str()));
    if (!interpolator || !node || !node->isOfType(SoVRMLTransform::getClassTypeId()) ||
        !interpolator->isOfType(SoVRMLInterpolator::getClassTypeId())) {
        return false;
    }
    static_cast<SoVRMLInterpolator*>(interpolator)->set_fraction.setValue(moved.fraction);
    auto* transform = static_cast<SoVRMLTransform*>(node);
    const SbVec3f place(moved.x, moved.y, moved.z);
    if (!moved.turns) return (transform->translation.getValue() - place).length() < 1e-3F;
    const SbRotation turn(place, moved.degrees * 3.14159265F / 180.0F);
    return transform->rotation.getValue().equals(turn, 1e-4F);
}

bool check(const std::filesystem::path& path) {
    const Expectation expected =
        read_expectation(std::filesystem::path(path).replace_extension(".expect"));
    std::ifstream file(path, std::ios::binary);
    std::stringstream buffer;
    buffer << file.rdbuf();
    const std::string text = buffer.str();
    SoInput input;
    input.setBuffer(text.data(), text.size());
    reported_error = false;
    SoVRMLGroup* root = SoDB::readAllVRML(&input);
    if (root == nullptr || reported_error) {
        std::cerr << path << ": Coin cannot read it\n";
        return false;
    }
    root->ref();
    bool good = true;
    VolumeSum sum;
    SoCallbackAction action;
    action.addTriangleCallback(SoNode::getClassTypeId(), add_triangle, &sum);
    action.apply(root);
    const double volume = sum.sixfold / 6.0;
    if (std::abs(volume - expected.volume) > 1e-4 * expected.volume) {
        std::cerr << path << ": volume " << volume << ", not " << expected.volume << '\n';
        good = false;
    }
    for (const std::string& group : expected.groups) {
        if (SoNode::getByName(SbName(group.c_str())) == nullptr) {
            std::cerr << path << ": no group " << group << '\n';
            good = false;
        }
    }
    for (const Moved& moved : expected.moved) {
        if (is_moved(moved)) continue;
        std::cerr << path << ": " << moved.interpolator << " does not move " << moved.node << '\n';
        good = false;
    }
    root->unref();
    std::cout << path << ": " << volume << " mm³, " << expected.groups.size() << " groups\n";
    return good;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return EXIT_FAILURE;
    SoDB::init();
    SoReadError::setHandlerCallback(
        [](const SoError* error, void*) {
            std::cerr << error->getDebugString().getString() << '\n';
            reported_error = true;
        },
        nullptr);
    int files = 0;
    bool good = true;
    for (const auto& entry : std::filesystem::directory_iterator(argv[1])) {
        if (entry.path().extension() != ".wrl") continue;
        ++files;
        good = check(entry.path()) && good;
    }
    return good && files > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
