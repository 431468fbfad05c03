package dev.eventchain.lsp.action;

import dev.eventchain.editing.FileEdit;

/**
 * A change that a hint proposes.
 *
 * @param certain whether it is the only one, and nothing else has to change with it, so that an
 *     editor may make it without a question
 */
record Fix(String title, FileEdit edit, boolean certain) {}
