/** The tree of the edited chain, with its menu and drag and drop. */
package dev.eventchain.eclipse.ui.editor.tree;
