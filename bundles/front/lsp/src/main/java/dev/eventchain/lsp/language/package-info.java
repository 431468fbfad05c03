/** Knowledge about the languages of texts, and its form in the protocol. */
package dev.eventchain.lsp.language;
