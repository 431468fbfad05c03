package dev.eventchain.benchmarks;

import org.eclipse.emf.ecore.EObject;

/** That a rule does not hold for an element. */
record Violation(String rule, EObject element) {}
