/** A session with an editor: what it asks, and what it is told. */
package dev.eventchain.lsp.session;
