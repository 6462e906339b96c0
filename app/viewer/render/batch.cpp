#include "batch.h"

#include <glad/gl.h>

#include <algorithm>

namespace se::view {

Batch::~Batch() {
    if (array_ == 0) return;
    glDeleteBuffers(2, buffers_);
    glDeleteVertexArrays(1, &array_);
}

void Batch::create() {
    if (array_ != 0) return;
    glGenVertexArrays(1, &array_);
    glGenBuffers(2, buffers_);
}

void Batch::bind() {
    create();
    glBindVertexArray(array_);
}

void Batch::describe(int buffer, std::size_t stride, const std::vector<VertexAttribute>& attributes,
                     bool perInstance) {
    bind();
    glBindBuffer(GL_ARRAY_BUFFER, buffers_[buffer]);
    for (const VertexAttribute& each : attributes) {
        const void* offset = reinterpret_cast<const void*>(each.offset);
        const auto step = static_cast<GLsizei>(stride);
        glEnableVertexAttribArray(each.location);
        if (each.bytes) {
            glVertexAttribIPointer(each.location, each.components, GL_UNSIGNED_BYTE, step, offset);
        } else if (each.signs) {
            glVertexAttribPointer(each.location, each.components, GL_BYTE, GL_TRUE, step, offset);
        } else {
            glVertexAttribPointer(each.location, each.components, GL_FLOAT, GL_FALSE, step, offset);
        }
        glVertexAttribDivisor(each.location, perInstance ? 1 : 0);
    }
}

void Batch::upload(int buffer, const void* data, std::size_t bytes) {
    bind();
    glBindBuffer(GL_ARRAY_BUFFER, buffers_[buffer]);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_DYNAMIC_DRAW);
    capacity_[buffer] = bytes;
}

void Batch::append(int buffer, std::size_t offset, const void* data, std::size_t bytes) {
    bind();
    if (offset + bytes > capacity_[buffer]) {
        const std::size_t capacity = std::max(offset + bytes, 2 * capacity_[buffer]);
        glBindBuffer(GL_COPY_READ_BUFFER, buffers_[buffer]);
        GLuint larger = 0;
        glGenBuffers(1, &larger);
        glBindBuffer(GL_COPY_WRITE_BUFFER, larger);
        glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(capacity), nullptr,
                     GL_STATIC_DRAW);
        if (offset > 0) {
            glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0,
                                static_cast<GLsizeiptr>(offset));
        }
        glDeleteBuffers(1, &buffers_[buffer]);
        buffers_[buffer] = larger;
        capacity_[buffer] = capacity;
    }
    glBindBuffer(GL_ARRAY_BUFFER, buffers_[buffer]);
    glBufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(bytes),
                    data);
}

}  // namespace se::view
