/** Checks of a workspace: what is checked, when, and which findings the editor shows. */
package dev.eventchain.lsp.check;
