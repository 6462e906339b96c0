#include "remedy_search.h"

#include <utility>

namespace se::view {

void RemedySearch::cancel() {
    about_.reset();
    query_.cancel();
}

void RemedySearch::start(std::shared_ptr<const Model> model, std::size_t alert,
                         const MeshFailure& failure) {
    about_ = alert;
    query_.start([model = std::move(model), failure](const Progress& progress) {
        return findRemedies(model->points, model->params, failure, progress);
    });
}

}  // namespace se::view
