/** The editors of constraints and templates: tokens, colours, content proposals and outlines. */
package dev.eventchain.eclipse.ui.text;
