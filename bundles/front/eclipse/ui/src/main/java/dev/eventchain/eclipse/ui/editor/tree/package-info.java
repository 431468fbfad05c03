/** The tree of the edited chain, with its menu, and what can be dragged in it. */
package dev.eventchain.eclipse.ui.editor.tree;
