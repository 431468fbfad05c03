/**
 * Calls of Java services and conversion of their arguments and results. Independent of templates.
 */
package dev.eventchain.m2t.services;
