// Questions to a cylinder or cone, and their answers as they are judged.
#pragma once

#include <surefoot/sweep.hpp>

#include "judge/judge.hpp"
#include "prove/bridge.hpp"

struct Asked {
    judge::Answer answer;
    judge::Verdict verdict;
};

inline Asked ask(const judge::Query& query) {
    const judge::Answer answer = surefoot::tools::ask(query);
    return {answer, judge::judge(query, answer).verdict};
}

/// The opposite claim must be refused, or the judge would agree with anything.
inline judge::Verdict verdict_of_the_opposite(const judge::Query& query, judge::Answer answer) {
    answer.hit = !answer.hit;
    answer.t = 0;
    answer.normal = {0, 1, 0};
    answer.point = query.from;
    return judge::judge(query, answer).verdict;
}

inline judge::Query query_of(judge::Kind kind, double radius, double height, const judge::Vec& from,
                             const judge::Vec& to) {
    judge::Query query;
    query.kind = kind;
    query.size = {radius, height, 0};
    query.from = from;
    query.to = to;
    return query;
}

inline void turn(judge::Query& query, double w, double x, double y, double z) {
    query.qw = w, query.qx = x, query.qy = y, query.qz = z;
}

inline void corners(judge::Query& query, const judge::Vec& a, const judge::Vec& b, const judge::Vec& c) {
    query.a = a, query.b = b, query.c = c;
}
