package dev.eventchain.eclipse.ui.editor.model;

import dev.eventchain.model.eventchain.EventChain;
import org.eclipse.emf.ecore.EReference;

/**
 * A heading in the tree, over elements of one kind.
 *
 * @param feature the reference of the chain that contains them; for data, only those that no
 *     component uses
 */
public record Group(EventChain chain, EReference feature) {}
