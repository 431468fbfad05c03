/** What is checked in a workspace, when, and which findings the editor shows. */
package dev.eventchain.lsp.check;
