/** What can be done about findings. */
package dev.eventchain.lsp.action;
