/**
 * The operations that templates have besides those of OCL, and calls of Java services as one of
 * them. Knows no template.
 */
package dev.eventchain.m2t.library;
