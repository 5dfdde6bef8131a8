#include "lines.hpp"

#include <array>
#include <cmath>

#include "number.hpp"

namespace surefoot::tools {
namespace {

void append_value(std::string& out, double value) {
    if (std::isfinite(value)) {
        append_number(out, value);
    } else {
        out += std::isnan(value) ? "\"nan\"" : (value > 0 ? "\"inf\"" : "\"-inf\"");
    }
}

template <std::size_t count>
void append_values(std::string& out, const std::array<double, count>& values, int wanted = static_cast<int>(count)) {
    for (int i = 0; i < wanted; ++i) {
        out += i == 0 ? '[' : ',';
        append_value(out, values[static_cast<std::size_t>(i)]);
    }
    out += ']';
}

void append_vec(std::string& out, const judge::Vec& v) {
    append_values<3>(out, {v.x, v.y, v.z});
}

}  // namespace

void append_record(std::string& out, const judge::Record& record) {
    const judge::Query& q = record.query;
    const judge::Answer& a = record.answer;
    out += "{\"shape\":{\"";
    out += judge::name_of(q.kind);
    out += "\":";
    if (judge::size_count(q.kind) == 1)
        append_value(out, q.size.x);
    else
        append_values<3>(out, {q.size.x, q.size.y, q.size.z}, judge::size_count(q.kind));
    out += "},\"from\":";
    append_vec(out, q.from);
    out += ",\"to\":";
    append_vec(out, q.to);
    out += ",\"rotate\":";
    append_values<4>(out, {q.qw, q.qx, q.qy, q.qz});
    out += q.one_sided ? ",\"one_sided\":true" : ",\"one_sided\":false";
    out += ",\"triangle\":[";
    append_vec(out, q.a);
    out += ',';
    append_vec(out, q.b);
    out += ',';
    append_vec(out, q.c);
    out += "],\"answer\":{\"hit\":";
    if (!a.hit) {
        out += "false}";
    } else {
        constexpr const char* features[] = {"face", "edge", "vertex"};
        constexpr const char* statuses[] = {"ok", "invalid", "overflow"};
        out += "true,\"t\":";
        append_value(out, a.t);
        out += ",\"point\":";
        append_vec(out, a.point);
        out += ",\"normal\":";
        append_vec(out, a.normal);
        out += ",\"feature\":\"";
        out += features[static_cast<int>(a.feature)];
        out += "\",\"status\":\"";
        out += statuses[static_cast<int>(a.status)];
        out += a.started_inside ? "\",\"started_inside\":true}" : "\",\"started_inside\":false}";
    }
    out += ",\"family\":\"";
    out += record.family.name;
    out += "\",\"verdict\":\"";
    out += judge::name_of(record.judgement.verdict);
    out += "\",\"why\":\"";
    out += record.judgement.why;
    out += "\",\"gap\":";
    append_value(out, record.judgement.gap);
    out += '}';
}

}  // namespace surefoot::tools
