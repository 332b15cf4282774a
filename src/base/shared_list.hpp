#pragma once
// A list whose copies share its elements until one of them changes its own.

#include <cstddef>
#include <memory>
#include <vector>

namespace signorini {

/// A value: copies are cheap, and no copy sees what another one writes. Threads may read copies at the same time; only
/// one may make, drop or change them.
template <class T> class SharedList {
public:
  std::size_t size() const { return list_->size(); }
  const T& operator[](std::size_t k) const { return (*list_)[k]; }
  auto begin() const { return list_->cbegin(); }
  auto end() const { return list_->cend(); }
  operator const std::vector<T>&() const { return *list_; }

  /// The elements for writing, until this list is copied.
  std::vector<T>& own() {
    if (list_.use_count() > 1) list_ = std::make_shared<std::vector<T>>(*list_);
    return *list_;
  }

private:
  std::shared_ptr<std::vector<T>> list_ = std::make_shared<std::vector<T>>();
};

} // namespace signorini
