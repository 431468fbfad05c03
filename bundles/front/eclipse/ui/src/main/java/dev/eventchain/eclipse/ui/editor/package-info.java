/**
 * The editor of event chains: a tree of the model, and the properties of what is selected in it.
 */
package dev.eventchain.eclipse.ui.editor;
