/**
 * Operations of templates beyond OCL, including calls of Java services. Independent of templates.
 */
package dev.eventchain.m2t.library;
