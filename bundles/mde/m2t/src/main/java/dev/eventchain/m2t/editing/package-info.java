/** Language service for templates, half-typed ones included. */
package dev.eventchain.m2t.editing;
