// SPDX-License-Identifier: MIT
#include "theory/course.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace testbed {
namespace {

/// Reads a file line by line, comments and empty lines left out, and knows where it is.
class Lines {
public:
    explicit Lines(const std::string &path) : m_path(path), m_stream(path) {
        if (!m_stream)
            throw FileError("cannot read " + path);
    }
    bool Next(std::istringstream &words) {
        for (std::string line; std::getline(m_stream, line);) {
            ++m_number;
            line.resize(std::min(line.find('#'), line.size()));
            if (line.find_first_not_of(" \t\r") == std::string::npos)
                continue;
            words.clear();
            words.str(line);
            return true;
        }
        return false;
    }
    [[noreturn]] void Fail(const std::string &what) const {
        throw FileError(m_path + ", line " + std::to_string(m_number) + ": " + what);
    }
    double Number(std::istringstream &words, const std::string &what) const {
        std::string word;
        if (!(words >> word))
            Fail("a number is missing: " + what);
        return ValueOf(word, what);
    }
    double ValueOf(const std::string &word, const std::string &what) const {
        char *end = nullptr;
        const double value = std::strtod(word.c_str(), &end);
        if (*end != '\0' || !std::isfinite(value))
            Fail(what + ": \"" + word + "\" is no number");
        return value;
    }
    void End(std::istringstream &words) const {
        std::string rest;
        if (words >> rest)
            Fail("\"" + rest + "\" is one too many");
    }
    void Check(bmr_error error) const {
        if (error != BMR_OK)
            Fail(bmr_error_describe(error));
    }

private:
    std::string m_path;
    std::ifstream m_stream;
    int m_number = 0;
};

bmr_pose ReadPose(const Lines &lines, std::istringstream &words) {
    const double x = lines.Number(words, "X"), y = lines.Number(words, "Y"),
                 angle = lines.Number(words, "ANGLE");
    return bmr_pose_from_angle(bmr_vec2_make(x, y), angle);
}

bmr_motion_piece ReadAlgebraic(const Lines &lines, std::istringstream &words, double time) {
    bmr_motion_piece piece = {};
    piece.kind = BMR_PIECE_ALGEBRAIC;
    piece.origin = time;
    bmr_algebraic_piece &algebraic = piece.as.algebraic;
    const double angle = lines.Number(words, "ANGLE");
    algebraic.start_c = std::cos(angle);
    algebraic.start_s = std::sin(angle);
    algebraic.a[0] = 1.0;
    double *target = nullptr; // of the coefficients that follow
    size_t count = 0, *degree = nullptr;
    for (std::string word; words >> word;) {
        double *const named = word == "x"   ? algebraic.x
                              : word == "y" ? algebraic.y
                              : word == "a" ? algebraic.a
                              : word == "b" ? algebraic.b
                                            : nullptr;
        if (named != nullptr) {
            target = named;
            degree = word == "x" || word == "y" ? &algebraic.degree : &algebraic.rotation_degree;
            count = 0;
            continue;
        }
        if (target == nullptr)
            lines.Fail("\"" + word + "\" is none of x, y, a, b");
        if (count > BMR_MOTION_MAX_DEGREE)
            lines.Fail("a degree above " + std::to_string(BMR_MOTION_MAX_DEGREE));
        target[count] = lines.ValueOf(word, "a coefficient");
        *degree = std::max(*degree, count++);
    }
    return piece;
}

/// The motion of one body while it is read.
struct Reading {
    MotionPointer motion;
    std::vector<double> times;
    std::vector<bmr_pose> poses;
};

void AddPiece(const Lines &lines, Reading &body, double time, const bmr_motion_piece &piece) {
    if (!body.times.empty())
        lines.Fail("samples and other pieces cannot be mixed");
    if (body.motion) {
        lines.Check(bmr_motion_change(body.motion.get(), time, &piece));
        return;
    }
    bmr_motion *made = nullptr;
    lines.Check(bmr_motion_create(&piece, nullptr, &made));
    body.motion.reset(made);
}

void ReadStatement(const Lines &lines, std::istringstream &words, const std::string &verb, Reading &body) {
    const double time = lines.Number(words, "T");
    if (verb == "sample") {
        if (body.motion)
            lines.Fail("samples and other pieces cannot be mixed");
        if (!body.times.empty() && time <= body.times.back())
            lines.Fail("times must ascend");
        body.times.push_back(time);
        body.poses.push_back(ReadPose(lines, words));
    } else if (verb == "rest") {
        AddPiece(lines, body, time, bmr_piece_rest(ReadPose(lines, words)));
    } else if (verb == "screw") {
        const bmr_pose pose = ReadPose(lines, words);
        const double vx = lines.Number(words, "VX"), vy = lines.Number(words, "VY"),
                     spin = lines.Number(words, "SPIN");
        AddPiece(lines, body, time, bmr_piece_screw(time, pose, bmr_vec2_make(vx, vy), spin));
    } else if (verb == "algebraic") {
        AddPiece(lines, body, time, ReadAlgebraic(lines, words, time));
    } else {
        lines.Fail("\"" + verb + "\" is none of time, body, rest, screw, algebraic, sample");
    }
    lines.End(words);
}

MotionPointer Finish(Reading &body) {
    bmr_motion *made = nullptr;
    if (!body.times.empty())
        body.motion.reset(bmr_motion_create_sampled(body.times.data(), body.poses.data(), body.times.size(),
                                                    nullptr, &made) == BMR_OK
                              ? made
                              : nullptr);
    if (body.motion)
        return std::move(body.motion);
    const bmr_motion_piece rest = bmr_piece_rest(bmr_pose_identity());
    if (bmr_motion_create(&rest, nullptr, &made) != BMR_OK)
        throw std::bad_alloc();
    return MotionPointer(made);
}

} // namespace

std::vector<bmr_vec2> ReadPolygonFile(const std::string &path) {
    Lines lines(path);
    std::vector<bmr_vec2> points;
    for (std::istringstream words; lines.Next(words);) {
        const double x = lines.Number(words, "x"), y = lines.Number(words, "y");
        points.push_back(bmr_vec2_make(x, y));
        lines.End(words);
    }
    if (points.empty())
        throw FileError(path + ": there is no point in it");
    return points;
}

MotionFile ReadMotionFile(const std::string &path) {
    Lines lines(path);
    MotionFile file;
    Reading bodies[2];
    int body = 0;
    for (std::istringstream words; lines.Next(words);) {
        std::string verb, name;
        words >> verb;
        if (verb == "time") {
            file.from = lines.Number(words, "FROM");
            file.until = lines.Number(words, "UNTIL");
            if (!(file.from < file.until))
                lines.Fail("FROM must be before UNTIL");
            lines.End(words);
        } else if (verb == "body") {
            if (!(words >> name) || (name != "A" && name != "B"))
                lines.Fail("a body is A or B");
            body = name == "B";
            lines.End(words);
        } else {
            ReadStatement(lines, words, verb, bodies[body]);
        }
    }
    if (!bodies[0].motion && !bodies[1].motion && bodies[0].times.empty() && bodies[1].times.empty())
        throw FileError(path + ": no body moves in it");
    for (int i = 0; i < 2; ++i)
        file.motions[i] = Finish(bodies[i]);
    return file;
}

} // namespace testbed
