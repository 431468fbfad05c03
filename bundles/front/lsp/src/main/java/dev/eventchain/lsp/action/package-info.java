/** Code actions for findings. */
package dev.eventchain.lsp.action;
