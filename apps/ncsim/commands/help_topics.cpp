// SPDX-License-Identifier: GPL-3.0-or-later
//
// Texts of `ncsim help TOPIC`, from help_topics.txt. A section begins with the line "== name", a
// topic with "== name: summary". The section "name notation" precedes the text of a topic.
#include "commands/help_topics.h"

#include <fmt/format.h>

#include <algorithm>

namespace ncsim::app {

extern const std::string_view kHelpTopics;

namespace {

struct Section {
    std::string_view name, summary;
    std::string_view text;
};

Section read_section(std::string_view text) {
    text.remove_prefix(std::string_view("== ").size());
    const std::size_t end = text.find('\n');
    const std::string_view head = text.substr(0, end);
    const std::size_t colon = head.find(": ");
    const bool is_topic = colon != std::string_view::npos;
    return {head.substr(0, colon), is_topic ? head.substr(colon + 2) : "", text.substr(end + 1)};
}

const std::vector<Section>& sections() {
    static const std::vector<Section> all = [] {
        std::vector<Section> read;
        for (std::string_view rest = kHelpTopics; !rest.empty();) {
            const std::size_t end = std::min(rest.find("\n== ") + 1, rest.size());
            const std::size_t size = end == 0 ? rest.size() : end;
            read.push_back(read_section(rest.substr(0, size)));
            rest.remove_prefix(size);
        }
        return read;
    }();
    return all;
}

// Returns the section `name`; an empty section if there is none.
Section section(std::string_view name) {
    const auto found = std::ranges::find(sections(), name, &Section::name);
    return found == sections().end() ? Section() : *found;
}

}  // namespace

std::string_view help_section(std::string_view name) {
    return section(name).text;
}

std::vector<std::string> topic_names() {
    std::vector<std::string> names;
    for (const Section& topic : sections()) {
        if (!topic.summary.empty()) names.emplace_back(topic.name);
    }
    return names;
}

std::string topic_text(std::string_view name) {
    const Section topic = section(name);
    if (topic.summary.empty()) return {};
    const Section notation = section(fmt::format("{} notation", name));
    const bool is_apart = notation.text.empty() || notation.text.starts_with("\n");
    return fmt::format("{}: {}\n{}{}{}", name, topic.summary, is_apart ? "" : "\n", notation.text,
                       topic.text);
}

std::string topic_list() {
    std::string text;
    for (const Section& topic : sections()) {
        if (!topic.summary.empty()) text += fmt::format("  {:<11} {}\n", topic.name, topic.summary);
    }
    return text;
}

}  // namespace ncsim::app
