package dev.eventchain.benchmarks;

import org.eclipse.emf.ecore.EObject;

/** A violation of a rule by an element. */
record Violation(String rule, EObject element) {}
