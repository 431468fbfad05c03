/**
 * The chain that is being edited: its commands, structure, file, and the texts and pictures of its
 * elements.
 */
package dev.eventchain.eclipse.ui.editor.model;
