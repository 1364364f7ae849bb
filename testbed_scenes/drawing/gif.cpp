// SPDX-License-Identifier: MIT
#include "drawing/gif.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <optional>
#include <stdexcept>

#ifdef BOOMERANG_HAS_GIF
#    include <gif_lib.h>

#    include "drawing/palette.h"
#    include "drawing/whole_file.h"
#endif

namespace testbed {

#ifndef BOOMERANG_HAS_GIF

std::unique_ptr<MovingPicture> MakeGif(const std::string &path) {
    throw std::runtime_error("cannot write " + path +
                             ": libgif was not there when this program was built (Debian: libgif-dev)");
}

#else

namespace {

/// The index of "as before"; the others are colours.
constexpr uint8_t kAsBefore = 255;
constexpr std::size_t kColours = 255, kMapSize = 256;
constexpr int kLeastDelay = 2;

int WriteTo(GifFileType *gif, const GifByteType *bytes, int count) {
    auto &file = *static_cast<std::ofstream *>(gif->UserData);
    file.write(reinterpret_cast<const char *>(bytes), count);
    return file ? count : 0;
}

struct Area {
    int left = 0, top = 0, width = 1, height = 1;
};

/// Each picture but the first holds what has changed, in the least rectangle, in colours of its own.
class Gif final : public MovingPicture {
public:
    explicit Gif(const std::string &path) : m_path(path), m_whole(path) {}
    ~Gif() override {
        if (m_gif != nullptr)
            EGifCloseFile(m_gif, nullptr);
    }

    void Add(const Image &image, double seconds) override {
        if (m_gif == nullptr)
            Open(image);
        if (image.width != m_last.width || image.height != m_last.height)
            throw std::logic_error("pictures of different sizes");
        const Area area = m_isFirst ? Area{0, 0, image.width, image.height} : Changed(image);
        PutControl(seconds);
        PutArea(image, area);
        m_last = image;
        m_isFirst = false;
    }

    void Finish() override {
        if (m_gif == nullptr)
            throw std::logic_error("no picture to write");
        GifFileType *gif = m_gif;
        m_gif = nullptr;
        errno = 0;
        Check(EGifCloseFile(gif, nullptr));
        m_file.close();
        Check(m_file ? GIF_OK : GIF_ERROR);
        m_whole.Finish();
    }

private:
    void Check(int status) const {
        if (status != GIF_OK)
            FailToWrite(m_path, errno);
    }

    void Open(const Image &image) {
        errno = 0;
        m_file.open(m_whole.WritePath(), std::ios::binary);
        Check(m_file ? GIF_OK : GIF_ERROR);
        m_gif = EGifOpen(&m_file, WriteTo, nullptr);
        Check(m_gif != nullptr ? GIF_OK : GIF_ERROR);
        EGifSetGifVersion(m_gif, true);
        Check(EGifPutScreenDesc(m_gif, image.width, image.height, 8, 0, nullptr));
        // Again and again, as browsers have it since Netscape 2.
        const GifByteType forever[] = {1, 0, 0};
        Check(EGifPutExtensionLeader(m_gif, APPLICATION_EXT_FUNC_CODE));
        Check(EGifPutExtensionBlock(m_gif, 11, "NETSCAPE2.0"));
        Check(EGifPutExtensionBlock(m_gif, sizeof forever, forever));
        Check(EGifPutExtensionTrailer(m_gif));
        m_last.width = image.width;
        m_last.height = image.height;
    }

    Area Changed(const Image &image) const {
        int left = image.width, right = -1, top = image.height, bottom = -1;
        std::size_t at = 0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x, ++at)
                if (image.pixels[at] != m_last.pixels[at]) {
                    left = std::min(left, x);
                    right = std::max(right, x);
                    top = std::min(top, y);
                    bottom = y;
                }
        return right < 0 ? Area() : Area{left, top, right - left + 1, bottom - top + 1};
    }

    void PutControl(double seconds) {
        m_owed += 100.0 * seconds;
        GraphicsControlBlock control = {};
        control.DisposalMode = DISPOSE_DO_NOT;
        control.DelayTime = std::clamp(static_cast<int>(std::lround(m_owed)), kLeastDelay, 65535);
        control.TransparentColor = m_isFirst ? NO_TRANSPARENT_COLOR : kAsBefore;
        m_owed = std::max(0.0, m_owed - control.DelayTime);
        GifByteType bytes[4];
        Check(static_cast<int>(EGifGCBToExtension(&control, bytes)) == 4 ? GIF_OK : GIF_ERROR);
        Check(EGifPutExtension(m_gif, GRAPHICS_EXT_FUNC_CODE, sizeof bytes, bytes));
    }

    void PutArea(const Image &image, const Area &area) {
        std::vector<uint32_t> changed;
        VisitRows(image, area, [&](std::size_t from, std::size_t until) {
            for (std::size_t at = from; at < until; ++at)
                if (IsNew(image, at))
                    changed.push_back(image.pixels[at]);
        });
        std::optional<Palette> palette;
        if (!changed.empty())
            palette.emplace(changed, kColours);
        GifColorType colours[kMapSize] = {};
        for (std::size_t i = 0; palette && i < palette->Colours().size(); ++i) {
            const uint32_t colour = palette->Colours()[i];
            colours[i] = {static_cast<GifByteType>(colour >> 16), static_cast<GifByteType>(colour >> 8),
                          static_cast<GifByteType>(colour)};
        }
        const std::unique_ptr<ColorMapObject, decltype(&GifFreeMapObject)> map(
            GifMakeMapObject(kMapSize, colours), GifFreeMapObject);
        if (!map)
            throw std::bad_alloc();
        Check(EGifPutImageDesc(m_gif, area.left, area.top, area.width, area.height, false, map.get()));
        std::vector<GifPixelType> row;
        VisitRows(image, area, [&](std::size_t from, std::size_t until) {
            row.clear();
            for (std::size_t at = from; at < until; ++at)
                row.push_back(IsNew(image, at) ? palette->IndexOf(image.pixels[at]) : kAsBefore);
            Check(EGifPutLine(m_gif, row.data(), static_cast<int>(row.size())));
        });
    }

    bool IsNew(const Image &image, std::size_t at) const {
        return m_isFirst || image.pixels[at] != m_last.pixels[at];
    }

    template <class Visit> static void VisitRows(const Image &image, const Area &area, Visit visit) {
        for (int y = area.top; y < area.top + area.height; ++y) {
            const auto from = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                              static_cast<std::size_t>(area.left);
            visit(from, from + static_cast<std::size_t>(area.width));
        }
    }

    const std::string m_path;
    WholeFile m_whole;
    std::ofstream m_file;
    GifFileType *m_gif = nullptr;
    Image m_last;
    bool m_isFirst = true;
    double m_owed = 0.0; ///< hundredths of a second that pictures should have stayed and did not yet
};

} // namespace

std::unique_ptr<MovingPicture> MakeGif(const std::string &path) {
    return std::make_unique<Gif>(path);
}

#endif

} // namespace testbed
