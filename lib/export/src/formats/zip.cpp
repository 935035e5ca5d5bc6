// SPDX-License-Identifier: GPL-3.0-or-later
//
// ZIP archives with deflate.
#include "formats/zip.h"

#include <zlib.h>

#include <limits>
#include <stdexcept>

namespace ncsim::exporter {

namespace {

constexpr std::uint32_t kLocalHeader = 0x04034b50;
constexpr std::uint32_t kDirectoryEntry = 0x02014b50;
constexpr std::uint32_t kDirectoryEnd = 0x06054b50;
constexpr std::uint16_t kVersion = 20;  // of the specification: deflate
constexpr std::uint16_t kDeflate = 8;
constexpr std::uint16_t kMidnight = 0;
constexpr std::uint16_t kFirstOfJanuary1980 = 0x21;

constexpr std::uint64_t kLimit = std::numeric_limits<std::uint32_t>::max();

void append(std::string& bytes, std::uint32_t number, int size) {
    for (int i = 0; i < size; ++i)
        bytes.push_back(static_cast<char>((number >> (8 * i)) & 0xFF));
}
void append16(std::string& bytes, std::uint16_t number) {
    append(bytes, number, 2);
}
void append32(std::string& bytes, std::uint64_t number) {
    append(bytes, static_cast<std::uint32_t>(number), 4);
}

void check_size(std::uint64_t size) {
    if (size > kLimit) throw std::runtime_error("the part is too large for a ZIP archive (4 GiB)");
}

std::string deflate_bytes(std::string_view content) {
    z_stream stream{};
    // A negative window size (15 bits) selects raw deflate, without the header of zlib.
    if (deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY) !=
        Z_OK) {
        throw std::runtime_error("cannot compress: zlib does not start");
    }
    std::string result(deflateBound(&stream, static_cast<uLong>(content.size())), '\0');
    check_size(result.size());
    // zlib does not write to the input, but the interface has no const.
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
    stream.avail_in = static_cast<uInt>(content.size());
    stream.next_out = reinterpret_cast<Bytef*>(result.data());
    stream.avail_out = static_cast<uInt>(result.size());
    const int status = deflate(&stream, Z_FINISH);
    const std::size_t size = stream.total_out;
    deflateEnd(&stream);
    if (status != Z_STREAM_END) throw std::runtime_error("cannot compress: zlib gave up");
    result.resize(size);
    return result;
}

std::uint32_t checksum(std::string_view content) {
    return static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(content.data()),
                                            static_cast<uInt>(content.size())));
}

}  // namespace

void ZipWriter::write(std::string_view bytes) {
    out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    written_ += bytes.size();
}

void ZipWriter::add(std::string_view name, std::string_view content) {
    check_size(content.size());
    const std::string packed = deflate_bytes(content);
    check_size(written_ + packed.size());

    // Fields that the local header and the directory entry share.
    std::string facts;
    append16(facts, kVersion);
    append16(facts, 0);  // flags
    append16(facts, kDeflate);
    append16(facts, kMidnight);
    append16(facts, kFirstOfJanuary1980);
    append32(facts, checksum(content));
    append32(facts, packed.size());
    append32(facts, content.size());
    append16(facts, static_cast<std::uint16_t>(name.size()));
    append16(facts, 0);  // no extra field

    append32(directory_, kDirectoryEntry);
    append16(directory_, kVersion);
    directory_ += facts;
    append16(directory_, 0);  // no comment
    append16(directory_, 0);  // first disk
    append16(directory_, 0);  // internal attributes
    append32(directory_, 0);  // external attributes
    append32(directory_, written_);
    directory_ += name;
    ++files_;

    std::string header;
    append32(header, kLocalHeader);
    header += facts;
    header += name;
    write(header);
    write(packed);
}

void ZipWriter::finish() {
    check_size(written_ + directory_.size());
    const std::uint64_t start = written_;
    std::string end;
    append32(end, kDirectoryEnd);
    append16(end, 0);  // this disk
    append16(end, 0);  // the directory's disk
    append16(end, files_);
    append16(end, files_);
    append32(end, directory_.size());
    append32(end, start);
    append16(end, 0);  // no comment
    write(directory_);
    write(end);
}

}  // namespace ncsim::exporter
