"""The app: a window that is played frame by frame."""

import time

from game.play.parts import Parts
from game.play.view.frame_stats import FrameTime, own_ns
from game.play.view.renderer import Frame
from game.world.background.kernel_warmup import cache_trouble
from game.world.files.settings import Settings
from game.world.rules.rule import Rule
from game.world.sessions.action import SetRule


class App:
    """Plays a scene with the parts of a window. `frame` is called once for each frame."""

    def __init__(self, window, scene, seed=0, p=None, settings=None):
        self.parts = Parts(window, scene, seed, settings or Settings(), self._switch)
        self._hears = None, True, window.fullscreen  # page, panel and screen of the last frame
        self._told_of_cache = False  # that kernels cannot be kept, or read
        self._seen = True  # somebody may see this frame, or has done something in it
        self._anew = False  # the whole window was laid out anew, and has to be shown
        if p is not None:
            self.parts.sessions.do(SetRule(Rule.with_p(p, scene.rule.schedule)))

    def frame(self, events, elapsed_ns, now_s, mouse_pos=None):
        """Hear events, run the iterations due after `elapsed_ns`, draw what changed; return whether anything did."""
        start, worked = time.perf_counter_ns(), own_ns()
        self._seen = bool(events) or not self.parts.window.hidden
        self.parts.display.now_s = now_s
        self.parts.sessions.begin_frame()
        self._fit()
        self.parts.background.update()
        self.parts.window.find_pointer()
        self._hear(events, now_s, mouse_pos)
        self.parts.frame_step.step(elapsed_ns, now_s)
        self._tell(now_s)
        self._fit()
        changed = self._show(now_s) if self._seen else False
        for each in self.parts.watchers:
            each.update(now_s)
        self._note(time.perf_counter_ns() - start, own_ns() - worked, now_s)
        return changed

    def _show(self, now_s):
        """Bring the window up to date; return whether anything in it changed."""
        changed, anew = self.parts.renderer.draw(self._frame(now_s)), self._anew
        self.parts.window.show(None if anew else changed)
        self._anew = False
        return bool(changed or anew)

    def _hear(self, events, now_s, mouse_pos):
        """Give events to what lies on top first, then to the cursor, the panel, the keys and the sand."""
        left = self.parts.cursor.handle_events(self._left_by_cards(events, now_s, mouse_pos))
        if self.parts.display.page:
            mouse_pos = None
        if self._seen and self.parts.display.panel_shown and self.parts.display.in_sight:
            left = self._left_by_panel(left, now_s, mouse_pos)
        for event in left:
            self.parts.event_router.handle_event(event)
        for event in events:
            self.parts.keys.note(event)
        self._let_go_of_hidden()
        self.parts.brush.hold()
        self.parts.pointer.follow(mouse_pos, self.parts.brush.painting)
        self.parts.stats_card.follow(mouse_pos, now_s)

    def _left_by_cards(self, events, now_s, mouse_pos):
        """Return the events that neither a page nor a card over the sand has taken; what a page hides hears none."""
        page = self.parts.display.page
        if page:
            events = page.handle_events(events, now_s, mouse_pos)
        for card in self.parts.cards:
            if card.shown and page:
                card.handle_events([], now_s, None)
            elif card.shown:
                events = card.handle_events(events, now_s, mouse_pos)
        return events

    def _left_by_panel(self, events, now_s, mouse_pos):
        """Return the events that the panel leaves to others: behind a page it hears none."""
        if self.parts.display.page:
            self.parts.panel.lay_out([], now_s, None)
            return events
        return self.parts.panel.lay_out(events, now_s, mouse_pos)

    def _let_go_of_hidden(self):
        """Let go of what is held when what hears it has changed, since what comes up is no longer heard."""
        hears = self.parts.display.page, self.parts.display.panel_shown, self.parts.window.fullscreen
        if hears != self._hears:
            self._hears = hears
            self.parts.let_go()

    def _tell(self, now_s):
        """Show what there is to say: trouble with journal and kernels, and lines that come and go."""
        self.parts.journals.update(self.parts.sessions.now, now_s)
        if not self._told_of_cache and cache_trouble():
            self._told_of_cache = True
            self.parts.notices.say(cache_trouble())
        self.parts.notices.pass_time(now_s)

    def _frame(self, now_s):
        """Return the Frame to be shown."""
        session, display = self.parts.sessions.now, self.parts.display
        if display.in_sight:
            self.parts.block_overlay.prepare()
            self.parts.differences.prepare(now_s)
        said = (
            self.parts.sessions.words
            or self.parts.frame_step.words
            or self.parts.rule_change.words
            or self.parts.recorder.said
            or self.parts.rewind.words
            or self.parts.fast_forward.words
        )
        layout, buttons = display.layout, self.parts.view_buttons
        strips = {tuple(layout.bar): self.parts.time_bar.drawing(session), tuple(layout.buttons): buttons.drawing()}
        if layout.status_line.height:
            strips[tuple(layout.status_line)] = self.parts.status_line.drawing(
                *(display.theme, layout.status_line, session, said, self.parts.timer.words),
                *(self.parts.notices.line, buttons.words or self.parts.camera.badge.words),
            )
        if layout.board.height:
            strips[tuple(layout.board)] = self.parts.stage.drawing(display.theme, layout.board)
        if display.panel_shown and display.in_sight:
            rect, strokes = self.parts.panel.drawing()
            strips[tuple(rect)] = strokes
        cards = (
            ("legend", self.parts.forecasting.legend),
            ("density", self.parts.density),
            ("figures", self.parts.stats_card),
        )
        for name, card in cards:
            if name in layout.cards:
                strips[tuple(layout.cards[name])] = card.drawing(display.theme, layout.cards[name])
        return Frame(
            now_s,
            display.page,
            session,
            self.parts.frame_step.passing(now_s),
            self.parts.ruler.marks(display.sand_view.view) + self._marks(display.sand_view.view),
            tuple(each for each in self.parts.overlays if each.shown),
            strips,
            self.parts.plots,
            self.parts.panel.ui if display.panel_shown else None,
        )

    def _marks(self, view):
        """Return the marks of the tool at the cursor or at the pointer."""
        if self.parts.camera.busy or self.parts.photo_import.shown:
            return ()
        brush, place = self.parts.brush, self.parts.pointer.place
        by_cursor = self.parts.cursor.on and not brush.by_mouse
        at = self.parts.cursor.place if by_cursor else place and view.place(*place)
        piece = at and brush.piece_at(at)
        carried = self.parts.stamp_preview.marks(*piece, view) if piece else ()
        if by_cursor:
            return (*carried, *self.parts.cursor.marks(view))
        return carried or (brush.marks(at, view) if at else brush.lasting_marks(view))

    def _note(self, work_ns, own_work_ns, now_s):
        """Note what the frame took."""
        self.parts.frame_step.note(work_ns, own_work_ns)
        session = self.parts.sessions.now
        frame = FrameTime(work_ns, own_work_ns, self.parts.frame_step.moving_ns, session.due, session.done)
        self.parts.frame_stats.count(frame, session, now_s)
        self.parts.status_line.update(session, self.parts.brush.material)

    def _fit(self):
        """Lay everything out, after the window or the lattice changed its size or what it looks like."""
        display, before, view = self.parts.display, self.parts.display.sand_view, self.parts.display.sand_view.view
        if not display.fit(self.parts.sessions.now):
            return
        self._anew = True
        self.parts.camera.keep(view if display.sand_view is before else None)
        self.parts.time_bar.place(display.layout.bar, display.theme)
        self.parts.view_buttons.place(display.layout.buttons, display.theme)
        self.parts.renderer.forget()
        self.parts.plots.forget()
        self.parts.panel.ui.invalidate()
        if display.page:
            display.page.forget()

    def _switch(self):
        """Show another session, or another scene: what else is heard in this frame finds it laid out."""
        self.parts.brush.let_go()
        self.parts.pointer.let_go()
        self.parts.display.lay_out_anew()
        self._fit()
