/** The editor of event chains: a tree of the model, and the properties of the selection. */
package dev.eventchain.eclipse.ui.editor;
