/** Calls of Java services and conversion of their arguments and results. Knows no template. */
package dev.eventchain.m2t.services;
