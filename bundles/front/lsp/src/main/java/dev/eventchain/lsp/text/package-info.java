/** The texts that are open in an editor, and places in them as the protocol counts them. */
package dev.eventchain.lsp.text;
