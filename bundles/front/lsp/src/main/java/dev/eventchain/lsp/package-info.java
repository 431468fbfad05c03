/** A server of the Language Server Protocol for projects, models, rules and templates. */
package dev.eventchain.lsp;
