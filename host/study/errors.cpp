#include "study/errors.h"

#include <algorithm>

namespace lacquer::study {

namespace {

template <typename Member>
std::vector<std::string> names_of(const Figure& figure, Member member) {
    std::vector<std::string> names;
    for (const ModelError& error : figure.errors)
        if (std::ranges::find(names, error.*member) == names.end()) names.push_back(error.*member);
    return names;
}

}  // namespace

std::vector<std::string> error_subjects(const Figure& figure) {
    return names_of(figure, &ModelError::subject);
}

std::vector<std::string> error_models(const Figure& figure) {
    return names_of(figure, &ModelError::model);
}

const ModelError* find_error(const Figure& figure, const std::string& subject,
                             const std::string& model) {
    const auto found = std::ranges::find_if(figure.errors, [&](const ModelError& error) {
        return error.subject == subject && error.model == model;
    });
    return found == figure.errors.end() ? nullptr : &*found;
}

double noise_of(const Figure& figure, const std::string& subject) {
    double noise = 0.0;
    for (const ModelError& error : figure.errors)
        if (error.subject == subject) noise = std::max(noise, error.noise);
    return noise;
}

std::optional<ModelError> overall_error(const Figure& figure, const std::string& model) {
    std::optional<ModelError> overall;
    double count = 0.0;
    for (const ModelError& error : figure.errors) {
        if (error.model != model) continue;
        const double mean = overall ? overall->mean : 0.0, noise = overall ? overall->noise : 0.0;
        if (!overall || error.max > overall->max) overall = error;
        overall->mean = mean + error.mean;
        overall->noise = noise + error.noise;
        ++count;
    }
    if (!overall) return std::nullopt;
    overall->mean /= count;
    overall->noise /= count;
    return overall;
}

}  // namespace lacquer::study
