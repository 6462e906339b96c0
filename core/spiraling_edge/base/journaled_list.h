/// A list whose changes can be undone and redone.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace se {

/// A list that can write down its changes, to go back to any of its earlier contents and forward
/// again. A change costs O(1) to write down, to undo and to redo, and the old or new element and
/// four bytes of memory. Until beginJournal() nothing is written down; a copy has the elements
/// alone. Requires fewer than 2^32 - 2 elements.
template <typename T>
class JournaledList {
  public:
    JournaledList() = default;
    // NOLINTNEXTLINE(google-explicit-constructor): takes the place of a std::vector
    JournaledList(std::vector<T> elements) : elements_(std::move(elements)) {}
    JournaledList(const JournaledList& other) : elements_(other.elements_) {}
    JournaledList(JournaledList&&) noexcept = default;
    JournaledList& operator=(const JournaledList& other) {
        if (this != &other) *this = JournaledList(other.elements_);
        return *this;
    }
    JournaledList& operator=(JournaledList&&) noexcept = default;
    ~JournaledList() = default;

    // Queries.
    std::size_t size() const { return elements_.size(); }
    bool empty() const { return elements_.empty(); }
    const T& operator[](std::size_t i) const { return elements_[i]; }
    const T& front() const { return elements_.front(); }
    const T& back() const { return elements_.back(); }
    auto begin() const { return elements_.begin(); }
    auto end() const { return elements_.end(); }
    // NOLINTNEXTLINE(google-explicit-constructor): takes the place of a std::vector
    operator const std::vector<T>&() const { return elements_; }

    friend bool operator==(const JournaledList& a, const std::vector<T>& b) {
        return a.elements_ == b;
    }
    friend bool operator==(const JournaledList& a, const JournaledList& b) {
        return a.elements_ == b.elements_;
    }

    // Changes.
    void set(std::size_t i, const T& element) {
        if (journal_) write({static_cast<std::uint32_t>(i), elements_[i]});
        elements_[i] = element;
    }
    void reserve(std::size_t size) { elements_.reserve(size); }
    void push_back(const T& element) {  // NOLINT(readability-identifier-naming)
        if (journal_) write({kAppended, {}});
        elements_.push_back(element);
    }
    void pop_back() {  // NOLINT(readability-identifier-naming)
        if (journal_) write({kRemoved, elements_.back()});
        elements_.pop_back();
    }
    void resize(std::size_t size, const T& element = {}) {
        if (!journal_) return elements_.resize(size, element);
        while (elements_.size() > size) pop_back();
        while (elements_.size() < size) push_back(element);
    }
    /// Replaces all elements. O(change).
    void assign(const std::vector<T>& elements) {
        if (!journal_) {
            elements_ = elements;
            return;
        }
        resize(elements.size());
        for (std::size_t i = 0; i < elements.size(); ++i) {
            if (!(elements_[i] == elements[i])) set(i, elements[i]);
        }
    }

    /// Moves the elements out. The list is empty then and has no journal.
    std::vector<T> take() {
        journal_.reset();
        return std::exchange(elements_, {});
    }

    // The journal.
    void beginJournal() { journal_ = std::make_unique<Journal>(); }
    bool hasJournal() const { return journal_ != nullptr; }
    /// Number of changes since beginJournal() at the present contents. A change after a return to
    /// earlier contents takes the place of the one that was made there: it must be the same again
    /// if those after it are still to be redone. Requires a journal.
    std::size_t changes() const {
        assert(journal_);
        return journal_->place;
    }
    /// Undoes or redoes changes, up to the contents at which changes() was `place`. Calls visit(i)
    /// for the position of each changed element.
    template <typename Visit>
    void moveTo(std::size_t place, Visit&& visit) {
        assert(journal_);
        Journal& journal = *journal_;
        assert(place <= journal.changes.size());
        while (journal.place > place) visit(exchange(journal.changes[--journal.place], true));
        while (journal.place < place) visit(exchange(journal.changes[journal.place++], false));
    }
    void moveTo(std::size_t place) {
        moveTo(place, [](std::size_t) {});
    }

  private:
    static constexpr std::uint32_t kAppended = std::numeric_limits<std::uint32_t>::max();
    static constexpr std::uint32_t kRemoved = kAppended - 1;
    struct Change {
        std::uint32_t where;  ///< Position of the changed element, kAppended or kRemoved.
        T element;            ///< The one that is not in the list at present.
    };
    struct Journal {
        std::vector<Change> changes;
        std::size_t place = 0;  ///< Changes before it are made, those from it on undone.
    };

    void write(const Change& change) {
        std::vector<Change>& changes = journal_->changes;
        if (journal_->place == changes.size()) {
            changes.push_back(change);
        } else {
            assert(changes[journal_->place].where == change.where);
            changes[journal_->place] = change;
        }
        ++journal_->place;
    }
    /// Undoes the change, or redoes it; returns the position of the element.
    std::size_t exchange(Change& change, bool undo) {
        if (change.where < kRemoved) {
            std::swap(change.element, elements_[change.where]);
            return change.where;
        }
        const bool shrinks = (change.where == kAppended) == undo;
        if (shrinks) {
            change.element = elements_.back();
            elements_.pop_back();
            return elements_.size();
        }
        elements_.push_back(change.element);
        return elements_.size() - 1;
    }

    std::vector<T> elements_;
    std::unique_ptr<Journal> journal_;
};

}  // namespace se
