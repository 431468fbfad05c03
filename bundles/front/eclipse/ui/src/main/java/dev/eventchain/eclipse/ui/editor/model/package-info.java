/** The edited chain: its commands, structure, file, and the texts and icons of its elements. */
package dev.eventchain.eclipse.ui.editor.model;
