/** What is known about the languages of texts, and how the protocol says it. */
package dev.eventchain.lsp.language;
